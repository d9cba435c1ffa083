// Time: playing, stepping, and the clock.

function nearest(time) {
  let best = 0;
  for (let i = 1; i < frames; ++i)
    if (Math.abs(meta.times[i] - time) < Math.abs(meta.times[best] - time)) best = i;
  return best;
}

function draw_clock() {
  $("clock").textContent = time_text();
  $("step").textContent = `step ${meta.steps[state.frame]}`;
  $("scrub").value = state.frame;
  $("scrub").setAttribute("aria-valuetext", time_text());
}

let started = 0, started_at = 0;
/// Returns the duration of the whole run: 25 frames per second, but at least 4 s.
const whole = () => Math.max(4, frames / 25) / state.pace;
function tick(now) {
  if (!state.playing) return;
  const [t0, t1] = [meta.times[0], meta.times[frames - 1]];
  const part = started_at + (now - started) / 1000 / whole();
  const frame = nearest(t0 + Math.min(part, 1) * (t1 - t0));
  if (frame !== state.frame) { state.frame = frame; redraw(); }
  if (part >= 1) play(false);
  else requestAnimationFrame(tick);
}
function play(on) {
  if (on && frames < 2) return;
  if (on && state.frame === frames - 1) state.frame = 0;
  state.playing = on;
  $("play").textContent = on ? "❚❚" : "▶";
  $("play").setAttribute("aria-label", on ? "pause" : "play");
  if (on) {
    const [t0, t1] = [meta.times[0], meta.times[frames - 1]];
    started = performance.now();
    started_at = (meta.times[state.frame] - t0) / (t1 - t0 || 1);
    requestAnimationFrame(tick);
  }
  redraw();
}
function show(frame) {
  if (state.playing) play(false);
  moves();
  state.frame = Math.max(0, Math.min(frames - 1, frame));
  redraw();
}

$("play").onclick = () => play(!state.playing);
$("back").onclick = () => show(state.frame - 1);
$("next").onclick = () => show(state.frame + 1);
$("scrub").oninput = (event) => show(Number(event.target.value));
$("pace").onchange = (event) => {
  const on = state.playing;
  state.pace = Number(event.target.value);
  if (on) { play(false); play(true); }
};
