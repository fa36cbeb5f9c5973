# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""check_report.py PROGRAM FIELD OUT: the report of a field, looked at by a browser."""
import json
import re
import subprocess
import sys
from pathlib import Path

from browser import Browser

program, field, out = sys.argv[1], sys.argv[2], Path(sys.argv[3])
out.mkdir(parents=True, exist_ok=True)
page = out / "report.html"
done = subprocess.run(
    [program, "report", field, "--mode", "0.3", "--mode", "0.6", "--generalized", "-o", page,
     "--sweep=-0.7:0.7:3", "--json", "--quiet"],
    capture_output=True, text=True,
)  # fmt: skip
assert done.returncode == 0, done.stderr
summary = json.loads(done.stdout)
assert summary["certificate"] == "certified" and summary["surfaces"] == 4, summary
first = page.read_bytes()
again = out / "again.html"
subprocess.run([program, "report", field, "--mode", "0.3", "--mode", "0.6", "--generalized", "-o", again,
                "--sweep=-0.7:0.7:3", "--quiet", "--threads", "1"], check=True,
               stdout=subprocess.DEVNULL)  # fmt: skip
assert again.read_bytes() == first, "the same page, whatever the threads"
text = first.decode()
assert not re.search(r'(src|href)="(?!#)', text), "nothing is loaded"

truth = {}
for mode in ("-0.6", "-0.3", "0.3", "0.6"):
    report = json.loads(subprocess.run(
        [program, "extract", field, f"--mode={mode}", "-o", out / "s.vtp", "--json", "--quiet"],
        capture_output=True, text=True, check=True).stdout)["surfaces"][0]  # fmt: skip
    truth[mode] = report

with Browser() as browser:
    browser.open(page.resolve().as_uri(), "window.report && window.report.ready")
    assert browser.evaluate("report.error") == ""

    def shown():
        return browser.evaluate("report.scene.drawn")["triangles"]

    def slide(i):
        browser.evaluate(f"(() => {{ const s = document.getElementById('slider'); s.value = {i}; "
                         "s.dispatchEvent(new Event('input')); })()")  # fmt: skip

    def click(selector):
        browser.evaluate(f"document.querySelector({json.dumps(selector)}).click()")

    # All modes, by the slider: counts are those of the program's own report.
    seen = []
    for i, mode in enumerate(truth):
        slide(i)
        assert shown() == truth[mode]["triangles"], (mode, shown())
        cells = browser.evaluate("[...document.querySelectorAll('#levels tr.chosen td')].map(c => c.textContent)")
        assert [int(c) for c in cells[1:5]] == [truth[mode][k] for k in (
            "components", "euler_characteristic", "boundary_loops", "triangles")], cells  # fmt: skip
        count = browser.evaluate("report.scene.count()")
        assert count["error"] == 0 and count["pixels"] > 20000 and count["colours"] > 50, count
        seen.append(count["pixels"])
    assert len(set(seen)) > 1, "other modes, other pictures"
    browser.picture(out / "report.png")

    # Hiding: components, and all.
    rows = browser.evaluate("document.querySelectorAll('#components tbody tr').length")
    assert rows == truth["0.6"]["components"]
    click("#components input")
    part = truth["0.6"]["parts"][0]["triangles"]
    assert shown() == truth["0.6"]["triangles"] - part
    click("#components input")
    click("#show-surface")
    assert shown() == 0
    lines_only = browser.evaluate("report.scene.count()")["pixels"]
    assert 0 < lines_only < seen[-1]
    click("#show-surface")

    # Colours: each way is another picture of the same pixels.
    before = browser.evaluate("report.scene.count()")
    palettes = set()
    for name in ("component", "medium", "dominant", "residual", "height"):
        browser.evaluate(f"(() => {{ const c = document.getElementById('colouring'); c.value = '{name}'; "
                         "c.dispatchEvent(new Event('change')); })()")  # fmt: skip
        count = browser.evaluate("report.scene.count()")
        assert abs(count["pixels"] - before["pixels"]) < 50, name
        palettes.add(count["colours"])
    assert len(palettes) > 2, palettes

    # Nothing of the table of components is cut off at its right side.
    table = "document.getElementById('parts')"
    widths = browser.evaluate(f"[{table}.scrollWidth, {table}.clientWidth]")
    assert widths[0] <= widths[1], widths

    # Turning, zooming.
    size = browser.evaluate("(() => { const b = document.getElementById('view').getBoundingClientRect(); "
                            "return [b.x + b.width / 2, b.y + b.height / 2]; })()")  # fmt: skip
    turn = browser.evaluate("report.scene.turn")
    mouse = dict(button="left", buttons=1)
    browser.call("Input.dispatchMouseEvent", type="mousePressed", x=size[0], y=size[1], clickCount=1, **mouse)
    browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=size[0] + 80, y=size[1] + 20, **mouse)
    browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=size[0] + 80, y=size[1] + 20, clickCount=1, **mouse)
    assert browser.evaluate("report.scene.turn") != turn
    zoom = browser.evaluate("report.scene.zoom")
    browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=size[0], y=size[1], deltaX=0, deltaY=-300)
    assert browser.evaluate("new Promise(r => setTimeout(() => r(report.scene.zoom), 300))") > zoom

    # Diagram, verdict.
    assert browser.evaluate("document.querySelectorAll('#diagram .marker').length") == 4
    assert browser.evaluate("document.querySelector('#diagram .euler').getAttribute('d').length") > 50
    assert browser.evaluate("document.getElementById('verdict').textContent") == "certified"
    hashes = browser.evaluate("[...document.querySelectorAll('dd.hash')].map(d => d.textContent)")
    assert len(hashes) == 4 and all(re.fullmatch("[0-9a-f]{64}", h) for h in hashes), hashes
    assert truth["0.6"] and browser.evaluate("document.querySelectorAll('#curve-table tbody tr').length") == 2

    # Nothing has left, and nothing can.
    assert browser.complaints() == [], browser.complaints()
    asked = browser.requests()
    assert all(url.startswith("file:") or url.startswith("about:") for url in asked), asked
    assert len([url for url in asked if url.startswith("file:")]) == 1, asked
    blocked = browser.evaluate("""new Promise(answer => {
        document.addEventListener('securitypolicyviolation', e => answer(e.effectiveDirective));
        fetch('https://example.org/').catch(() => setTimeout(() => answer('no event'), 2000)); })""")
    assert blocked == "connect-src", blocked
    inline = browser.evaluate("""new Promise(answer => {
        document.addEventListener('securitypolicyviolation', e => answer(e.effectiveDirective));
        const s = document.createElement('script'); s.textContent = 'window.foreign = 1';
        document.body.append(s); setTimeout(() => answer('no event'), 2000); })""")
    assert inline == "script-src-elem" and browser.evaluate("window.foreign === undefined")

# An uncertain field: what is not stable is faded, and counted by reason.
uncertain = out / "uncertain.html"
options = [field, "--mode", "0.3", "--uncertainty", "2%", "--json", "--quiet"]
done = subprocess.run([program, "report", *options, "--no-sweep", "-o", uncertain], capture_output=True, text=True)
assert done.returncode == 0, done.stderr
summary = json.loads(done.stdout)
extracts = [
    json.loads(subprocess.run([program, "extract", *options, *more, "-o", out / "s.vtp"],
                              capture_output=True, text=True, check=True).stdout)
    for more in ([], ["--mode", "1", "--mode=-1"])
]  # fmt: skip
stable = [level["stability"] for level in extracts[1]["surfaces"] + extracts[1]["curves"]]
assert summary["stable_components"] == sum(s["stable_components"] for s in stable), summary
with Browser() as browser:
    browser.open(uncertain.resolve().as_uri(), "window.report && window.report.ready")
    assert browser.evaluate("report.error") == ""
    shown = browser.evaluate("report.scene.drawn")
    assert shown["triangles"] == extracts[0]["surfaces"][0]["triangles"]
    assert 0 < shown["faded"] < shown["triangles"], shown
    light = "(() => { report.scene.draw(); const g = report.scene.gl; " \
            "const w = g.drawingBufferWidth, h = g.drawingBufferHeight, a = new Uint8Array(4 * w * h); " \
            "g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, a); return a.reduce((s, x) => s + x, 0); })()"
    faded = browser.evaluate(light)
    browser.picture(out / "uncertain.png")
    browser.evaluate("document.getElementById('fade-unstable').click()")
    assert browser.evaluate("report.scene.drawn")["faded"] == 0
    assert browser.evaluate(light) < faded
    rows = browser.evaluate("[...document.querySelectorAll('#stability-table tr')].map("
                            "r => [...r.children].map(c => c.textContent))")  # fmt: skip
    assert len(rows) == 4 and len(stable) == 3
    for row, s in zip(rows[1:], stable):
        assert int(row[3]) == s["unstable_tets"]
        seen = {name.replace(" ", "_"): int(n) for name, n in zip(rows[0][4:], row[4:]) if int(n)}
        assert seen == s["reasons"], (seen, s["reasons"])

print(f"report of {len(first)} bytes: {sum(t['triangles'] for t in truth.values())} triangles, "
      f"{len(seen)} modes, all shown and counted; nothing left the page")  # fmt: skip
