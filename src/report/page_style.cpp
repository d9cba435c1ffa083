#include "report/page_style.hpp"

namespace blocks::report {
namespace {

void put_before_names(std::string& text, const std::string& mark,
                      const std::string& prefix) {
  for (auto at = text.find(mark); at != text.npos;
       at = text.find(mark, at + mark.size()))
    text.insert(at + mark.size(), prefix);
}

}  // namespace

const char* const page_style = R"css(
:root {
  --paper: #f6f5f1; --sheet: #ffffff; --ink: #22242a; --muted: #5d616b; --line: #dedcd5;
  --accent: #0a5c9e; --done: #3b7a57; --unsound: #b3261e; --limit: #c77700; --failed: #7d1d3f; --open: #b9b6ad;
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums;
}
main { max-width: 70rem; margin: 0 auto; padding: 2.2rem clamp(1rem, 4vw, 3.2rem) 4rem; background: var(--sheet); min-height: 100vh; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
a { color: var(--accent); text-decoration-thickness: .06em; text-underline-offset: .18em; }
header { border-bottom: 1px solid var(--line); padding-bottom: 1.1rem; margin-bottom: 1.4rem; }
.kicker { margin: 0 0 .3rem; color: var(--muted); font-size: .86rem; letter-spacing: .02em; }
h1 { font-size: 1.75rem; line-height: 1.2; font-weight: 650; letter-spacing: -.01em; margin: 0 0 .45rem; text-wrap: balance; }
h2 { font-size: 1.22rem; line-height: 1.3; font-weight: 650; margin: 2.6rem 0 .6rem; break-after: avoid; }
h3 { font-size: 1rem; font-weight: 650; margin: 1.6rem 0 .4rem; break-after: avoid; }
p { margin: 0 0 .9rem; max-width: 44rem; }
.lead { font-size: 1.06rem; }
.swept { margin: 0; color: var(--muted); }
small, .note { color: var(--muted); font-size: .86rem; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: .84em; }
pre { background: var(--paper); padding: .8rem 1rem; overflow-x: auto; border-radius: 6px; }

.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(15rem, 1fr)); gap: .8rem; margin: 1.2rem 0; }
.card { border: 1px solid var(--line); border-radius: 8px; padding: .7rem .9rem .75rem; break-inside: avoid; }
.card b { display: block; font-size: 1.28rem; font-weight: 650; letter-spacing: -.01em; white-space: nowrap; }
.card b small { font-size: .8rem; font-weight: 400; }
.card span { display: block; color: var(--muted); font-size: .86rem; line-height: 1.4; }

.outcomes { display: flex; height: .7rem; border-radius: 4px; overflow: hidden; margin: .5rem 0 .5rem; }
.outcomes i { display: block; min-width: 3px; }
.key { display: flex; flex-wrap: wrap; gap: .2rem 1.4rem; list-style: none; padding: 0; margin: 0 0 1rem; font-size: .92rem; }
.key i { display: inline-block; width: .7rem; height: .7rem; border-radius: 3px; margin-right: .45rem; }
.done { background: var(--done); } .unsound { background: var(--unsound); } .time_limit { background: var(--limit); }
.failed { background: var(--failed); } .not_finished { background: var(--open); }

figure { margin: 1rem 0 1.4rem; break-inside: avoid; }
figure svg text { white-space: pre; }
figure svg, figure img { display: block; width: 100%; height: auto; }
figcaption { color: var(--muted); font-size: .88rem; line-height: 1.45; margin-top: .5rem; max-width: 46rem; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: .4rem 2rem; }
.pair figure { margin: .4rem 0 1rem; }
.pair figcaption { margin: 0 0 .3rem; color: var(--ink); font-weight: 600; font-size: .92rem; }
.pair figcaption small { font-weight: 400; }

.wide { overflow-x: auto; margin: .8rem 0 1rem; }
table { border-collapse: collapse; font-size: .875rem; line-height: 1.4; }
.wide table { min-width: 100%; }
caption { text-align: left; color: var(--muted); padding-bottom: .4rem; }
th, td { padding: .32rem .7rem .32rem 0; text-align: right; vertical-align: baseline; white-space: nowrap; }
th:last-child, td:last-child { padding-right: 0; }
th:first-child, td:first-child, .text { text-align: left; }
thead th { font-weight: 600; border-bottom: 1.5px solid var(--ink); vertical-align: bottom; line-height: 1.25; }
tbody td, tbody th { border-bottom: 1px solid var(--line); font-weight: 400; }
tbody th[scope="row"] { text-align: left; white-space: normal; min-width: 11rem; }
tbody th small, td small { display: block; }
td.range { color: var(--muted); }
tr.bad td, tr.bad th { background: color-mix(in srgb, var(--unsound) 6%, transparent); }
small.message { white-space: normal; max-width: 26rem; min-width: 14rem; overflow-wrap: anywhere; }
.state { display: inline-flex; align-items: center; gap: .4rem; }
.state i { width: .55rem; height: .55rem; border-radius: 50%; }
th[data-sort] { cursor: pointer; }
th[aria-sort="ascending"]::after { content: " ↑"; } th[aria-sort="descending"]::after { content: " ↓"; }
.facts th { text-align: left; font-weight: 400; color: var(--muted); white-space: normal; }
.facts td { text-align: left; white-space: normal; overflow-wrap: anywhere; }
.facts { margin: .6rem 0 1.2rem; }
.fault { border-left: 4px solid var(--unsound); padding: .3rem 0 .3rem .9rem; }
dl { display: grid; grid-template-columns: minmax(8rem, max-content) 1fr; gap: .35rem 1.4rem; font-size: .92rem; max-width: 54rem; }
dt { font-weight: 600; } dd { margin: 0; color: var(--muted); }
@media (max-width: 40rem) {
  figure { overflow-x: auto; } figure > svg, figure > img { min-width: 36rem; } .pair figure > svg { min-width: 0; }
}
@media (max-width: 40rem) { dl { grid-template-columns: 1fr; } dd { margin-bottom: .5rem; } }
@media print {
  @page { margin: 16mm 15mm; }
  body { background: none; font-size: 10pt; } main { padding: 0; max-width: none; }
  a { color: inherit; text-decoration: none; } .wide { overflow: visible; } table { font-size: 8pt; }
  .pair { grid-template-columns: 1fr 1fr; } figcaption, p, dl { max-width: none; }
  thead { display: table-header-group; } tr { break-inside: avoid; }
  .outcomes, .key i, .state i { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

const char* const page_script = R"js(
for (const head of document.querySelectorAll("th[data-sort]")) {
  head.tabIndex = 0;
  const sort = () => {
    const row = head.parentNode, body = row.closest("table").tBodies[0];
    const column = [...row.children].indexOf(head);
    const up = head.getAttribute("aria-sort") !== "ascending";
    for (const other of row.children) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    const key = (line) => line.children[column]?.dataset.v ?? line.children[column]?.textContent ?? "";
    const order = (a, b) => {
      const x = key(a), y = key(b);
      if (x === "" || y === "") return (x === "") - (y === "");
      const both = x - y;
      return (up ? 1 : -1) * (Number.isNaN(both) ? x.localeCompare(y) : both);
    };
    body.append(...[...body.rows].sort(order));
  };
  head.addEventListener("click", sort);
  head.addEventListener("keydown", (event) => { if (event.key === "Enter") sort(); });
}
)js";

std::string unique_ids(std::string svg, const std::string& prefix) {
  if (const auto begin = svg.find("<svg"); begin != std::string::npos)
    svg.erase(0, begin);
  else
    return svg;
  for (const char* mark : {" id=\"", "url(#", "href=\"#"})
    put_before_names(svg, mark, prefix);
  return svg;
}

}  // namespace blocks::report
