// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
'use strict';
// The page: its tables, its diagram, and what of the surfaces is shown.
const byId = id => document.getElementById(id);
const facts = JSON.parse(byId('facts').textContent);
const report = window.report = {ready: false, error: '', mode: 0};

function element(name, attributes = {}, ...children) {
  const svg = ['svg', 'path', 'line', 'circle', 'text', 'g', 'title', 'rect'].includes(name);
  const made = svg ? document.createElementNS('http://www.w3.org/2000/svg', name)
                   : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith('on')) made[key] = value; else made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function table(head, rows, id) {
  const cells = (tag, row) => row.map(cell => element(tag, {}, cell instanceof Node ? cell : String(cell)));
  return element('table', id ? {id} : {}, element('thead', {}, element('tr', {}, ...cells('th', head))),
                 element('tbody', {}, ...rows.map(row => element('tr', {}, ...cells('td', row)))));
}

const number = x => x === null ? '–' : Number.isInteger(x) ? String(x) : Number(x).toPrecision(6).replace(/\.?0+$/, '');

// --- What the page carries: arrays, compressed, one after the other. ----------------------------
async function arrays() {
  const text = byId('geometry').textContent.trim();
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const all = await new Response(stream).arrayBuffer();
  const kinds = {f4: Float32Array, u4: Uint32Array, i1: Int8Array};
  return ([kind, offset, length]) => new kinds[kind](all, offset, length);
}

// --- Colours. -----------------------------------------------------------------------------------
function hue(i) {
  const h = (i * .61803398875 + .58) % 1 * 6, s = .55, v = .92;
  const f = k => { const x = (k + h) % 6; return v - v * s * Math.max(0, Math.min(x, 4 - x, 1)); };
  return [f(5), f(3), f(1)].map(x => Math.round(255 * x));
}
const ramp = t => {  // from blue over grey to orange
  const a = [49, 104, 173], b = [225, 225, 225], c = [222, 119, 33];
  const mix = (p, q, s) => p.map((x, i) => Math.round(x + (q[i] - x) * s));
  return t < .5 ? mix(a, b, 2 * t) : mix(b, c, 2 * t - 1);
};

const colourings = {
  component: surface => {
    const colours = new Uint8Array(surface.points.length);
    for (let t = 0; t < surface.triangles.length / 3; ++t)
      for (let k = 0; k < 3; ++k)
        colours.set(hue(surface.component[t]), 3 * surface.triangles[3 * t + k]);
    return colours;
  },
  medium: surface => surface.medium.map(x => 2 * Math.min(127, Math.abs(x))),
  dominant: surface => surface.dominant.map(x => 2 * Math.min(127, Math.abs(x))),
  residual: surface => {
    const colours = new Uint8Array(surface.points.length);
    const most = surface.residual.reduce((m, x) => Math.max(m, Math.abs(x)), 0) || 1;
    surface.residual.forEach((x, i) => colours.set(ramp(.5 + .5 * x / most), 3 * i));
    return colours;
  },
  height: surface => {
    const colours = new Uint8Array(surface.points.length);
    for (let i = 0; i < surface.points.length; i += 3)
      colours.set(ramp(.5 + .5 * surface.points[i + 2]), i);
    return colours;
  },
};

// --- The scene. ---------------------------------------------------------------------------------
// Triangles in the order of components, stable ones first, so that those shown are ranges
// [first, count, whether they are stable].
function sorted(triangles, component, stable) {
  const order = [...component.keys()].sort((a, b) => component[a] - component[b] || stable[b] - stable[a] || a - b);
  const result = {triangles: new Uint32Array(triangles.length), component: new Uint32Array(component.length), ranges: []};
  order.forEach((t, i) => {
    result.triangles.set(triangles.subarray(3 * t, 3 * t + 3), 3 * i);
    result.component[i] = component[t];
    const own = result.ranges[component[t]] ||= [], last = own[own.length - 1];
    if (last && last[2] === Boolean(stable[t])) ++last[1]; else own.push([i, 1, Boolean(stable[t])]);
  });
  return result;
}

async function build() {
  const scene = report.scene = new Scene(byId('view'));
  const array = await arrays();
  report.surfaces = facts.surfaces.map(level => {
    const a = level.arrays, surface = {hidden: new Set()};
    for (const name of ['points', 'normals', 'medium', 'dominant', 'residual']) surface[name] = array(a[name]);
    const component = array(a.component);
    const stable = a.stable ? array(a.stable) : new Int8Array(component.length).fill(1);
    Object.assign(surface, sorted(array(a.triangles), component, stable));
    surface.item = scene.addSurface(surface.points, surface.normals, surface.triangles);
    return surface;
  });
  const ink = {outline: [.55, .55, .55], linear: [.80, .10, .15], planar: [.05, .25, .80], unresolved: [.85, .1, .85]};
  report.lines = {};
  for (const [name, place] of Object.entries(facts.lines))
    report.lines[name] = scene.addLines(array(place), ink[name.replace('_unstable', '')]);
  colour();
  show(report.mode);
}

function colour() {
  if (!report.surfaces) return;
  const how = colourings[byId('colouring').value];
  for (const surface of report.surfaces) report.scene.colour(surface.item, how(surface));
  report.scene.draw();
}

function update() {
  if (!report.surfaces) return;
  const fading = Boolean(facts.uncertainty) && byId('fade-unstable').checked;
  report.surfaces.forEach((surface, i) => {
    surface.item.shown = i === report.mode && byId('show-surface').checked;
    surface.item.ranges = surface.ranges.filter((own, c) => !surface.hidden.has(c)).flat();
    surface.item.fading = fading;
  });
  for (const [name, item] of Object.entries(report.lines)) {
    item.shown = byId('show-' + name.replace('_unstable', '')).checked;
    item.fading = fading && name.endsWith('_unstable');
  }
  report.scene.draw();
  const {triangles, segments} = report.scene.drawn;
  byId('state').textContent = `${triangles} triangles and ${segments} segments shown`;
}

function show(mode) {
  report.mode = mode;
  const level = facts.surfaces[mode];
  if (level) {
    byId('slider').value = mode;
    byId('mode').textContent = level.mode;
    document.querySelectorAll('#levels tbody tr').forEach((row, i) => row.classList.toggle('chosen', i === mode));
    document.querySelectorAll('.marker').forEach((mark, i) => mark.classList.toggle('chosen', i === mode));
    parts(level, report.surfaces && report.surfaces[mode]);
  }
  update();
}

function parts(level, surface) {
  const most = 200;
  const rows = level.parts.slice(0, most).map((part, c) => {
    const box = element('input', {type: 'checkbox', 'aria-label': `component ${c}`});
    box.checked = !surface || !surface.hidden.has(c);
    box.onchange = () => { if (surface) surface.hidden[box.checked ? 'delete' : 'add'](c); update(); };
    const swatch = element('span', {class: 'swatch'});
    swatch.style.background = `rgb(${hue(c)})`;
    return [box, swatch, c, part.euler_characteristic, part.boundary_loops, part.genus, part.triangles, number(part.area)];
  });
  const head = ['show', '', 'component', 'χ', 'loops', 'genus', 'triangles', 'area'];
  const more = level.parts.length > most ? [element('p', {}, `and ${level.parts.length - most} more`)] : [];
  byId('parts').replaceChildren(table(head, rows, 'components'), ...more);
}

// --- Tables. ------------------------------------------------------------------------------------
function tables() {
  const rows = facts.surfaces.map((level, i) => {
    const link = element('a', {href: '#levels', onclick: () => { show(i); return false; }}, level.mode);
    return [link, level.parts.length, level.euler_characteristic, level.boundary_loops, level.triangles,
            number(level.area), level.distance_bound === null ? '–' : number(level.distance_bound), level.unresolved];
  });
  byId('topology').append(table(
    ['mode', 'components', 'χ', 'loops', 'triangles', 'area', 'distance at most', 'unresolved cells'], rows, 'levels'));
  if (facts.curves.length)
    byId('curves').append(table(['curves', 'components', 'closed', 'length', 'vertices', 'unresolved cells'],
      facts.curves.map(c => [c.kind, c.components, c.closed, number(c.length), c.vertices, c.unresolved]), 'curve-table'));
  uncertainty();
  if (facts.unresolved.length) {
    byId('unresolved').append(table(['cell', 'reason', 'mode', 'centre'],
      facts.unresolved.map(u => [u.cell, u.reason, u.mode, u.centre.map(number).join(', ')]), 'unresolved-table'));
    if (facts.unresolved_count > facts.unresolved.length)
      byId('unresolved').append(element('p', {}, `and ${facts.unresolved_count - facts.unresolved.length} more`));
  } else {
    byId('unresolved').append(element('p', {}, 'No cell is left out.'));
  }
}

function uncertainty() {
  const known = facts.uncertainty;
  if (!known) { byId('uncertainty-section').remove(); byId('fade-unstable').parentElement.remove(); return; }
  byId('radius').textContent = known.radius;
  byId('fade-unstable').onchange = update;
  const reasons = [...new Set(known.levels.flatMap(level => Object.keys(level.reasons)))];
  byId('uncertainty').append(table(
    ['mode', 'stable components', 'stable crossings', 'tetrahedra not stable', ...reasons.map(r => r.replaceAll('_', ' '))],
    known.levels.map(l => [l.of, `${l.stable_components} of ${l.components}`, `${l.stable_crossings} of ${l.crossings}`,
                           l.unstable_tets, ...reasons.map(r => l.reasons[r] || 0)]), 'stability-table'));
}

// --- The diagram. -------------------------------------------------------------------------------
function diagram() {
  const sweep = facts.sweep;
  if (!sweep) { byId('sweep-section').remove(); return; }
  const width = 900, height = 260, left = 60, right = 20, top = 16, bottom = 34;
  const x = m => left + (m - sweep.from) / (sweep.to - sweep.from) * (width - left - right);
  const known = sweep.intervals.filter(i => i.euler !== null);
  const low = Math.min(0, ...known.map(i => i.euler)), high = Math.max(1, ...known.map(i => i.euler));
  const y = e => top + (high - e) / (high - low || 1) * (height - top - bottom);
  const svg = element('svg', {viewBox: `0 0 ${width} ${height}`, id: 'diagram', role: 'img',
                              'aria-label': 'Euler characteristic against the mode'});
  const text = (px, py, what, anchor) =>
    svg.append(element('text', {x: px, y: py, 'text-anchor': anchor}, what));
  for (const e of new Set([low, 0, high])) {
    svg.append(element('line', {class: 'grid', x1: left, x2: width - right, y1: y(e), y2: y(e)}));
    text(left - 6, y(e) + 4, String(e), 'end');
  }
  for (let i = 0; i <= 4; ++i) {
    const m = sweep.from + (sweep.to - sweep.from) * i / 4;
    text(x(m), height - 12, number(m), 'middle');
  }
  text(left, 12, 'Euler characteristic', 'start');
  let path = '';
  for (const i of known) path += `M${x(i.low)} ${y(i.euler)}H${x(i.high)}`;
  svg.append(element('path', {class: 'euler', d: path}));
  for (const e of sweep.events) {
    const tick = element('line', {class: 'event', x1: x(e.mode), x2: x(e.mode), y1: height - bottom, y2: height - bottom + 7});
    tick.append(element('title', {}, `${e.mode}: ${e.changes}`));
    svg.append(tick);
  }
  facts.surfaces.forEach((level, i) => {
    const marker = element('line', {class: 'marker', x1: x(level.value), x2: x(level.value), y1: top, y2: height - bottom});
    marker.onclick = () => show(i);
    svg.append(marker);
  });
  svg.onclick = e => {
    const box = svg.getBoundingClientRect();
    const m = sweep.from + ((e.clientX - box.left) / box.width * width - left) / (width - left - right) * (sweep.to - sweep.from);
    const distance = level => Math.abs(level.value - m);
    show(facts.surfaces.reduce((best, level, i) => distance(level) < distance(facts.surfaces[best]) ? i : best, 0));
  };
  byId('sweep').append(svg);
}

// ------------------------------------------------------------------------------------------------
(async () => {
  tables();
  diagram();
  for (const name of ['outline', 'linear', 'planar', 'unresolved']) {
    const box = byId('show-' + name);
    if (!(name in facts.lines)) box.parentElement.remove(); else box.onchange = update;
  }
  byId('show-surface').onchange = update;
  byId('colouring').onchange = colour;
  byId('reset').onclick = () => { report.scene && (report.scene.reset(), report.scene.draw()); };
  const slider = byId('slider');
  slider.max = Math.max(0, facts.surfaces.length - 1);
  slider.disabled = facts.surfaces.length < 2;
  slider.oninput = () => show(Number(slider.value));
  try {
    await build();
  } catch (error) {
    report.error = String(error);
    byId('state').textContent = report.error;
    show(report.mode);
  }
  report.ready = true;
})();
