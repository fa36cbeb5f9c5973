# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""check_pages.py SITE: every page of the site, looked at by a browser.

A page has text and a title of its own, shows its pictures, fits its window, asks for nothing but
files of the site, and is reached from the first page.
"""
import sys
from pathlib import Path

from browser import Browser

LOOK = """(() => {
  const article = document.querySelector('[role=main]');
  return {
    title: document.title,
    text: article ? article.innerText.length : 0,
    broken: [...document.images].filter(i => !(i.complete && i.naturalWidth)).map(i => i.src),
    pictures: document.images.length,
    wide: document.documentElement.scrollWidth - window.innerWidth,
    links: [...document.querySelectorAll('a[href]')].map(a => a.href.split('#')[0])
  };
})()"""
PICTURES = ("index", "README", "reference/command-line", "reference/python", "reference/cxx/extract",
            "reference/reports/extract", "theory/README", "examples/gallery/README")  # fmt: skip


def main():
    site = Path(sys.argv[1]).resolve()
    html, pictures = site / "html", site / "pictures"
    pictures.mkdir(exist_ok=True)
    pages = sorted(p for p in html.rglob("*.html") if "_static" not in p.parts)
    faults, titles, links, seen = [], {}, {}, 0
    with Browser() as browser:
        for page in pages:
            browser.events.clear()
            browser.open(page.as_uri(), f"document.readyState == 'complete' && location.href == '{page.as_uri()}'")
            found = browser.evaluate(LOOK)
            name = page.relative_to(html).as_posix()
            seen += found["pictures"]
            links[page.as_uri()] = found["links"]
            titles.setdefault(found["title"], []).append(name)
            if found["text"] < 40 and name != "search.html":
                faults.append(f"{name}: no text")
            if found["wide"] > 0:
                faults.append(f"{name}: {found['wide']} pixels too wide")
            faults += [f"{name}: no picture {source}" for source in found["broken"]]
            faults += [f"{name}: asks for {url}" for url in browser.requests() if not url.startswith(("file:", "data:"))]
            faults += [f"{name}: {text}" for text in browser.complaints()]
            if name.removesuffix(".html") in PICTURES:
                browser.picture(pictures / f"{name.removesuffix('.html').replace('/', '-')}.png")
    faults += [f"{names} have one title, {title}" for title, names in titles.items() if len(names) > 1]
    reached, ahead = set(), [(html / "index.html").as_uri()]
    while ahead:
        page = ahead.pop()
        if page in links and page not in reached:
            reached.add(page)
            ahead += links[page]
    faults += [f"{page}: not reached" for page in links
               if page not in reached and not page.endswith("/search.html")]
    for fault in faults:
        print(fault)
    print(f"{len(pages)} pages and {seen} pictures looked at")
    sys.exit(1 if faults or len(pages) < 60 or seen < 50 else 0)


if __name__ == "__main__":
    main()
