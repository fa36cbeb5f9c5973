// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
'use strict';
// Triangles and lines in WebGL 2, turned by the pointer. Positions are in the unit ball.
const Scene = (() => {
  const kFaded = .7;  // the share of white in what is faded
  const surfaceShader = [`#version 300 es
    in vec3 position; in vec3 normal; in vec3 colour;
    uniform mat4 view; uniform mat3 turn;
    out vec3 n; out vec3 c;
    void main() { n = turn * normal; c = colour; gl_Position = view * vec4(position, 1.); }`,
  `#version 300 es
    precision highp float; uniform float fade;
    in vec3 n; in vec3 c; out vec4 result;
    void main() {
      float l = length(n), light = l > 0. ? abs(n.z) / l : .6;
      vec3 shade = gl_FrontFacing ? c : mix(c, vec3(.35), .35);
      result = vec4(mix(shade * (.3 + .7 * light), vec3(1.), fade), 1.);
    }`];
  const lineShader = [`#version 300 es
    in vec3 position; uniform mat4 view;
    void main() { gl_Position = view * vec4(position, 1.); gl_Position.z -= 1e-4 * gl_Position.w; }`,
  `#version 300 es
    precision highp float; uniform vec3 ink; out vec4 result;
    void main() { result = vec4(ink, 1.); }`];

  function program(gl, [vertex, fragment]) {
    const made = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw gl.getShaderInfoLog(shader);
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw gl.getProgramInfoLog(made);
    return made;
  }

  // Rotations as quaternions [x, y, z, w].
  const times = ([a, b, c, d], [e, f, g, h]) => [
    d * e + a * h + b * g - c * f, d * f - a * g + b * h + c * e,
    d * g + a * f - b * e + c * h, d * h - a * e - b * f - c * g];
  const about = (axis, angle) => {
    const s = Math.sin(angle / 2);
    return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
  };
  const rows = ([x, y, z, w]) => [
    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]];
  const first = times(about([1, 0, 0], -1.1), about([0, 0, 1], -.6));

  return class {
    constructor(canvas) {
      this.canvas = canvas;
      const gl = this.gl =
        canvas.getContext('webgl2', {antialias: true, preserveDrawingBuffer: true});
      if (!gl) throw 'This browser offers no WebGL 2: tables and diagram are all there is.';
      this.surfaces = program(gl, surfaceShader);
      this.lines = program(gl, lineShader);
      this.items = [];
      this.reset();
      this.listen();
      new ResizeObserver(() => this.draw()).observe(canvas);
    }

    reset() { this.turn = first; this.zoom = 1; this.shift = [0, 0]; }

    buffer(target, data) {
      const buffer = this.gl.createBuffer();
      this.gl.bindBuffer(target, buffer);
      this.gl.bufferData(target, data, this.gl.STATIC_DRAW);
      return buffer;
    }

    attribute(program, name, buffer, size, type, normalized) {
      const gl = this.gl, place = gl.getAttribLocation(program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, type, normalized, 0, 0);
    }

    // A surface of points (Float32Array), normals (Int8Array) and triangles (Uint32Array).
    addSurface(points, normals, triangles) {
      const gl = this.gl, item = {kind: 'surface', shown: true, ranges: [[0, triangles.length / 3]]};
      item.vao = gl.createVertexArray();
      gl.bindVertexArray(item.vao);
      this.attribute(this.surfaces, 'position', this.buffer(gl.ARRAY_BUFFER, points), 3, gl.FLOAT, false);
      this.attribute(this.surfaces, 'normal', this.buffer(gl.ARRAY_BUFFER, normals), 3, gl.BYTE, true);
      item.colours = this.buffer(gl.ARRAY_BUFFER, new Uint8Array(points.length).fill(200));
      this.attribute(this.surfaces, 'colour', item.colours, 3, gl.UNSIGNED_BYTE, true);
      this.buffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
      gl.bindVertexArray(null);
      this.items.push(item);
      return item;
    }

    colour(item, colours) {
      this.gl.bindBuffer(this.gl.ARRAY_BUFFER, item.colours);
      this.gl.bufferData(this.gl.ARRAY_BUFFER, colours, this.gl.STATIC_DRAW);
    }

    // Segments between each two points.
    addLines(points, ink) {
      const gl = this.gl, item = {kind: 'lines', shown: true, ink, count: points.length / 3};
      item.vao = gl.createVertexArray();
      gl.bindVertexArray(item.vao);
      this.attribute(this.lines, 'position', this.buffer(gl.ARRAY_BUFFER, points), 3, gl.FLOAT, false);
      gl.bindVertexArray(null);
      this.items.push(item);
      return item;
    }

    draw() {
      const {gl, canvas} = this, ratio = window.devicePixelRatio || 1;
      const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
      const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      const r = rows(this.turn), aspect = width / height;
      // Central projection from five radii away; the ball fills the shorter side.
      const distance = 5, f = 4.6 * this.zoom * Math.min(1, aspect), near = 3, far = 7;
      const A = (far + near) / (near - far), B = 2 * far * near / (near - far);
      const view = new Float32Array(16);
      for (let i = 0; i < 3; ++i) {
        view[4 * i] = f / aspect * r[0][i];
        view[4 * i + 1] = f * r[1][i];
        view[4 * i + 2] = A * r[2][i];
        view[4 * i + 3] = -r[2][i];
      }
      view[12] = this.shift[0] * distance;
      view[13] = this.shift[1] * distance;
      view[14] = -A * distance + B;
      view[15] = distance;
      const turn = new Float32Array(9);
      for (let i = 0; i < 3; ++i) for (let k = 0; k < 3; ++k) turn[3 * i + k] = r[k][i];
      gl.viewport(0, 0, width, height);
      gl.clearColor(1, 1, 1, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      this.drawn = {triangles: 0, segments: 0, faded: 0};
      for (const item of this.items) {
        if (!item.shown) continue;
        gl.bindVertexArray(item.vao);
        if (item.kind === 'surface') {
          gl.useProgram(this.surfaces);
          gl.uniformMatrix4fv(gl.getUniformLocation(this.surfaces, 'view'), false, view);
          gl.uniformMatrix3fv(gl.getUniformLocation(this.surfaces, 'turn'), false, turn);
          const fade = gl.getUniformLocation(this.surfaces, 'fade');
          for (const [start, count, stable] of item.ranges) {
            const faded = item.fading && !stable;
            gl.uniform1f(fade, faded ? kFaded : 0);
            gl.drawElements(gl.TRIANGLES, 3 * count, gl.UNSIGNED_INT, 12 * start);
            if (faded) this.drawn.faded += count;
            this.drawn.triangles += count;
          }
        } else {
          gl.useProgram(this.lines);
          gl.uniformMatrix4fv(gl.getUniformLocation(this.lines, 'view'), false, view);
          gl.uniform3fv(gl.getUniformLocation(this.lines, 'ink'),
                         item.fading ? item.ink.map(x => x + kFaded * (1 - x)) : item.ink);
          gl.drawArrays(gl.LINES, 0, item.count);
          this.drawn.segments += item.count / 2;
        }
      }
      gl.bindVertexArray(null);
    }

    // How many pixels are not background, and how many colours they have.
    count() {
      const gl = this.gl, bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      const colours = new Set();
      let pixels = 0;
      for (let i = 0; i < bytes.length; i += 4) {
        const colour = bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2];
        if (colour !== 0xffffff) { ++pixels; colours.add(colour); }
      }
      return {pixels, colours: colours.size, error: gl.getError()};
    }

    rotate(x, y) {
      this.turn = times(times(about([0, 1, 0], x), about([1, 0, 0], y)), this.turn);
      const size = Math.hypot(...this.turn);
      this.turn = this.turn.map(v => v / size);
      this.draw();
    }

    listen() {
      const {canvas} = this, pointers = new Map();
      canvas.onpointerdown = e => { canvas.setPointerCapture(e.pointerId); pointers.set(e.pointerId, e); };
      canvas.onpointerup = canvas.onpointercancel = e => pointers.delete(e.pointerId);
      canvas.onpointermove = e => {
        const before = pointers.get(e.pointerId);
        if (!before) return;
        const x = e.clientX - before.clientX, y = e.clientY - before.clientY;
        if (pointers.size === 2) {
          const other = [...pointers.entries()].find(([id]) => id !== e.pointerId)[1];
          const apart = p => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY) || 1;
          this.zoom *= apart(e) / apart(before);
        }
        pointers.set(e.pointerId, e);
        if (e.shiftKey || e.buttons === 2) {
          this.shift[0] += 2 * x / canvas.clientWidth;
          this.shift[1] -= 2 * y / canvas.clientHeight;
          this.draw();
        } else {
          this.rotate(x * .008, y * .008);
        }
      };
      canvas.oncontextmenu = e => e.preventDefault();
      canvas.addEventListener('wheel', e => {
        e.preventDefault();
        this.zoom = Math.min(100, Math.max(.2, this.zoom * Math.exp(-e.deltaY * .0015)));
        this.draw();
      }, {passive: false});
      canvas.onkeydown = e => {
        const step = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key];
        if (step) this.rotate(...step);
        else if (e.key === '+' || e.key === '-') { this.zoom *= e.key === '+' ? 1.1 : 1 / 1.1; this.draw(); }
        else return;
        e.preventDefault();
      };
    }
  };
})();
