#include "app/live/page_text.h"

namespace etalon {
namespace {

constexpr std::string_view text = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width,initial-scale=1">
<link rel="icon" href="data:,">
<title>Etalon</title>
<style>
:root{color-scheme:light dark;--paper:#fff;--card:#f6f7f9;--ink:#1c232b;--quiet:#57626d;--rule:#dfe3e8;
--line:#0072b2;--bad:#b3400f}
@media (prefers-color-scheme:dark){:root{--paper:#12161b;--card:#1a2027;--ink:#e4e8ec;--quiet:#9aa6b2;
--rule:#2c343d;--line:#4aa3e0;--bad:#ff9a62}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);overflow-wrap:anywhere;
font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,Helvetica,Arial,"DejaVu Sans",sans-serif;
font-variant-numeric:tabular-nums}
header,main{max-width:90rem;margin:0 auto;padding:1rem 1.25rem}
header{display:flex;flex-wrap:wrap;gap:.5rem 1.25rem;align-items:center;padding-bottom:0}
h1{font-size:1.25rem;margin:0;flex:1 1 12rem}
h2{font-size:1rem;margin:0 0 .5rem}
progress{width:100%;height:.5rem;accent-color:var(--line)}
main{display:grid;grid-template-columns:minmax(0,1fr) minmax(16rem,24rem);gap:1.25rem}
@media (max-width:56rem){main{grid-template-columns:minmax(0,1fr)}}
#figures{grid-column:1/-1;display:flex;flex-wrap:wrap;gap:.25rem 2rem;margin:0}
#figures div{display:flex;gap:.5rem}
dt,.quiet{color:var(--quiet)}
dd{margin:0}
section{background:var(--card);border:1px solid var(--rule);border-radius:.5rem;padding:1rem;align-self:start}
#picture{display:block;width:100%;height:auto;image-rendering:pixelated;background:#000}
button{font:inherit;color:inherit;background:var(--card);border:1px solid var(--rule);border-radius:.4rem;
padding:.3rem .8rem;cursor:pointer}
button:disabled{opacity:.5;cursor:default}
button:focus-visible{outline:2px solid var(--line);outline-offset:2px}
#stop{color:var(--bad);border-color:currentColor}
[role=tablist]{display:flex;flex-wrap:wrap;gap:.4rem;margin-bottom:.75rem}
[aria-selected=true]{border-color:var(--line);color:var(--line)}
.scale{height:.6rem;border-radius:.3rem;margin-top:.75rem;
background:linear-gradient(90deg,#000004,#3b0f70,#8c2981,#de4968,#fe9f6d,#fcfdbf)}
#ends{display:flex;justify-content:space-between}
svg{display:block;width:100%;height:auto;overflow:visible}
svg text{fill:var(--quiet);font-size:11px}
svg line{stroke:var(--rule)}
svg polyline{fill:none;stroke:var(--line);stroke-width:2;stroke-linejoin:round}
svg circle{fill:var(--line)}
</style>
<header>
<h1 id="scene">Etalon</h1>
<span id="stage" role="status">Waiting for the program.</span>
<button id="stop" type="button">Stop and write the image</button>
<progress id="part" max="1" value="0" aria-label="Part of the rendering that is done"></progress>
</header>
<main>
<dl id="figures">
<div><dt>Time</dt><dd id="seconds">0 s</dd></div>
<div><dt>Samples per pixel</dt><dd id="samples">0</dd></div>
<div><dt>Expected error (relMSE)</dt><dd id="error">unknown</dd></div>
</dl>
<section>
<div role="tablist" aria-label="What is shown">
<button type="button" role="tab" aria-selected="true" data-name="image">Image</button>
<button type="button" role="tab" aria-selected="false" data-name="samples">Samples</button>
<button type="button" role="tab" aria-selected="false" data-name="seconds">Time</button>
</div>
<img id="picture" alt="The image as far as it has come">
<div id="legend" hidden><div class="scale"></div><div id="ends"><span id="least"></span><span id="most"></span></div></div>
</section>
<section>
<h2>Error against time</h2>
<svg id="chart" viewBox="0 0 360 240" role="img" aria-label="Expected relMSE against seconds"></svg>
<p id="no_errors" class="quiet">An error is told from how the image changes while its samples double.</p>
</section>
</main>
<script>
'use strict';
const by_id = id => document.getElementById(id);
const stages = {preparing: 'Preparing the scene.', rendering: 'Rendering.',
  writing: 'Writing the image.', over: 'Done: the image is written.', unwritten: 'Ended: no image was written.'};
const has_ended = () => state.stage === 'over' || state.stage === 'unwritten';
let shown = 'image', state = null, is_stopping = false, loaded = {}, urls = {};

const number = (x, digits = 3) => x === 0 ? '0' :
  Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5 ? x.toExponential(digits - 1) : String(+x.toPrecision(digits));

const element = (name, attributes, text = '') => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
};

// Both axes are logarithmic: errors fall by a power of the time.
function draw(errors) {
  const points = errors.filter(p => p.relmse > 0 && p.seconds > 0);
  by_id('no_errors').hidden = points.length > 0;
  const chart = by_id('chart');
  chart.replaceChildren();
  if (points.length === 0) return;
  const range = values => {
    const low = Math.log10(Math.min(...values)), high = Math.log10(Math.max(...values));
    return high - low < 0.5 ? [low - 0.25, high + 0.25] : [low, high];
  };
  const [x0, x1] = range(points.map(p => p.seconds)), [y0, y1] = range(points.map(p => p.relmse));
  const left = 56, right = 348, top = 12, bottom = 212;
  const x = value => left + (Math.log10(value) - x0) / (x1 - x0) * (right - left);
  const y = value => bottom - (Math.log10(value) - y0) / (y1 - y0) * (bottom - top);
  for (let i = 0; i < 4; ++i) {
    const error = 10 ** (y0 + (y1 - y0) * i / 3), at = y(error);
    chart.append(element('line', {x1: left, x2: right, y1: at, y2: at}),
      element('text', {x: left - 6, y: at + 4, 'text-anchor': 'end'}, number(error, 2)));
  }
  for (let i = 0; i < 3; ++i) {
    const seconds = 10 ** (x0 + (x1 - x0) * i / 2);
    chart.append(element('text', {x: x(seconds), y: bottom + 18,
      'text-anchor': ['start', 'middle', 'end'][i]}, number(seconds, 2) + ' s'));
  }
  chart.append(element('polyline', {points: points.map(p => `${x(p.seconds)},${y(p.relmse)}`).join(' ')}));
  for (const p of points) chart.append(element('circle', {cx: x(p.seconds), cy: y(p.relmse), r: 3}));
}

function show_picture() {
  if (urls[shown]) by_id('picture').src = urls[shown];
  by_id('picture').alt = {image: 'The image as far as it has come',
    samples: 'Samples of each pixel, more of them brighter',
    seconds: 'Time that each pixel took, more of it brighter'}[shown];
  by_id('legend').hidden = shown === 'image';
  if (!state || shown === 'image') return;
  const most = shown === 'samples' ? state.most_samples : state.most_seconds;
  const [scale, unit] = shown === 'samples' ? [1, ' samples'] : [1e6, ' µs'];
  by_id('least').textContent = number(scale * most / 256) + unit + ' or less';
  by_id('most').textContent = number(scale * most) + unit + ' a pixel';
}

async function load(name) {
  const version = state.version;
  if (loaded[name] === version) return;
  const reply = await fetch(name + '.png');
  if (!reply.ok) return;
  const old = urls[name];
  urls[name] = URL.createObjectURL(await reply.blob());
  loaded[name] = version;
  if (name === shown) show_picture();
  if (old) URL.revokeObjectURL(old);
}

function show_state() {
  document.title = `${Math.round(100 * state.part)} % ${state.scene}`;
  by_id('scene').textContent = state.scene;
  by_id('stage').textContent = is_stopping && state.stage === 'rendering' ? 'Stopping.' : stages[state.stage];
  by_id('part').value = state.stage === 'over' ? 1 : state.part;
  by_id('seconds').textContent = state.seconds.toFixed(1) + ' s';
  by_id('samples').textContent = number(state.samples);
  const last = state.errors[state.errors.length - 1];
  by_id('error').textContent = last ? number(last.relmse) : 'unknown';
  by_id('stop').disabled = is_stopping || has_ended() || state.stage === 'writing';
  draw(state.errors);
  show_picture();
}

async function update() {
  const start = performance.now();
  try {
    state = await (await fetch('state.json')).json();
    show_state();
    const all = has_ended() ? ['image', 'samples', 'seconds'] : [shown];
    if (state.version > 0) for (const name of all) await load(name);
    if (has_ended()) return;
  } catch {
    if (state && has_ended()) return;
    by_id('stage').textContent = 'No answer: the program has ended, or the connection is lost.';
    by_id('stop').disabled = true;
  }
  setTimeout(update, Math.min(1000, Math.max(500, 4 * (performance.now() - start))));
}

by_id('stop').onclick = async () => {
  is_stopping = true;
  by_id('stop').disabled = true;
  try {
    is_stopping = (await fetch('stop', {method: 'POST'})).ok;
  } catch {
    is_stopping = false;
  }
};
for (const tab of document.querySelectorAll('[role=tab]')) {
  tab.onclick = () => {
    for (const other of document.querySelectorAll('[role=tab]')) {
      other.setAttribute('aria-selected', String(other === tab));
    }
    shown = tab.dataset.name;
    show_picture();
    if (state && state.version > 0) load(shown).catch(() => {});
  };
}
update();
</script>
</html>
)";

}  // namespace

std::string_view page_text() {
    return text;
}

}  // namespace etalon
