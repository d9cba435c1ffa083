// The pointer: hover, click, drag, wheel and fingers.

const pointers = new Map();
let moved = 0;
const click = 6;  // pixels; a pointer that moves less between down and up clicks
model.addEventListener("pointerdown", (event) => {
  try { model.setPointerCapture(event.pointerId); } catch { /* not a real pointer */ }
  pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
  if (pointers.size === 1) moved = 0;
});
model.addEventListener("pointermove", (event) => {
  const last = pointers.get(event.pointerId);
  if (event.pointerType === "mouse") follow_pointer([event.offsetX, event.offsetY]);
  if (!last) return;
  const here = [event.offsetX, event.offsetY], others = [...pointers].filter(([id]) => id !== event.pointerId);
  moved += Math.hypot(here[0] - last[0], here[1] - last[1]);
  if (others.length === 0) {
    if (moved >= click) pan(here[0] - last[0], here[1] - last[1]);
  } else {
    const [x, y] = others[0][1];
    pan((here[0] - last[0]) / 2, (here[1] - last[1]) / 2);
    zoom(Math.hypot(here[0] - x, here[1] - y) / Math.max(1, Math.hypot(last[0] - x, last[1] - y)),
      (here[0] + x) / 2, (here[1] + y) / 2);
  }
  pointers.set(event.pointerId, here);
});
model.addEventListener("pointerup", (event) => {
  if (pointers.delete(event.pointerId) && moved < click && pointers.size === 0)
    pick(place_at([event.offsetX, event.offsetY]), event.shiftKey);
});
model.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
model.addEventListener("pointerleave", () => follow_pointer(null));
model.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event.offsetX, event.offsetY);
}, {passive: false});
model.addEventListener("dblclick", (event) => zoom(2, event.offsetX, event.offsetY));

const pick = ({block, side}, is_second) => is_second ? pick_second(block) : pick_first(block, side);

let cursor_asked = false;
function follow_pointer(at) {
  pointer_at = at;
  if (at && state.crosshair) toggle("crosshair");
  if (cursor_asked || !state.ready) return;
  cursor_asked = true;
  requestAnimationFrame(() => { cursor_asked = false; draw_cursor(); });
}
