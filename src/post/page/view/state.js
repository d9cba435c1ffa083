// The page of `blocks view`. The state is one object. Every function that changes it calls
// redraw(), which draws once before the next animation frame. The scripts of this folder follow
// each other in one script element.
"use strict";

const $ = (id) => document.getElementById(id);
const meta = JSON.parse($("meta").textContent);
const frames = meta.times.length;
const state = {
  ready: false, frame: frames - 1, playing: false, pace: 1,
  view: {x: 0, y: 0, scale: 1},  // model point in the middle of the canvas; pixels per model length
  fitted: true,  // the view shows everything and follows the size of the window
  colour: "material", map: "", reversed: false,  // an empty map: the one that suits the quantity
  typed: {},  // [low, high] of colours by quantity; null where the range is automatic
  followed: "speed",  // the quantity of the chart
  picked: [],  // at most two blocks
  side: -1,  // the picked side of the first of them, from 0; -1: none
  original: false, forces: false, cracks: meta.cracks !== undefined, labels: false, mirror: meta.mirror !== null,
  arrows: "", full_arrows: {},  // no arrows; typed values of arrows of full length, by kind
  crosshair: false,  // a cursor in the middle of the view, for use with the keyboard
};

/// Draws everything once before the next picture of the screen.
let asked = false;
function redraw() {
  if (asked || !state.ready) return;
  asked = true;
  requestAnimationFrame(draw);
}
function draw() {
  asked = false;
  draw_model();
  draw_axes();
  draw_cursor();
  draw_colours();
  draw_clock();
  draw_numbers();
}

/// Returns the name of a material by its number, and the words for the material of a block.
const material_name = (number) => meta.material_names[number] ?? number;
const material_of = (block) => meta.material_names[meta.material[block]] ?? `material ${meta.material[block]}`;

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);
const font = (size, weight = "") => `${weight} ${size}px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;

/// Gives a canvas the pixels of its place on the page, and clears it.
function size_canvas(canvas, its_pen) {
  const ratio = window.devicePixelRatio || 1;
  const w = Math.round(canvas.clientWidth * ratio), h = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
  its_pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  its_pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
}
