#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# report: one page that needs nothing else, whatever files are called, and of bounded size; in a browser, Chromium where
# it is there, its sliders and layers show as many regions as build writes.
# Usage: test_report.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

odd='a <b>&"</script><!--.json'
cp "$root/examples/data/a_wrench.json" "$directory/x"
mv x "$(printf '%s' "$odd" | tr / _)"
odd=$(ls)
cat > two.svg << 'END'
<svg xmlns="http://www.w3.org/2000/svg"><path id="one" d="M0 0C40 90 60 -70 100 20"/>
<path id="&lt;script&gt;x&lt;/script&gt;" d="M0 50A30 40 10 1 1 70 60z"/></svg>
END
asked='--query self-intersect,hull --offset 0.1 --rule evenodd'
# shellcheck disable=SC2086
run report --eps 1e-4,1e-2 --methods sfa,bca,bilens --repeat 1 $asked "$odd" two.svg -o page.html
expect_status 0
expect_silence
grep -q '^<title>Bounding arcs: a &lt;b&gt;&amp;&quot;.* and 1 more</title>$' page.html ||
  fail 'the title is not escaped'
cp "$odd" $'\xff\xfe.json'
run report --eps 1 --methods bca --repeat 1 --stability none $'\xff\xfe.json'
expect_status 0
iconv -f UTF-8 -t UTF-8 "$results/out" > /dev/null 2>&1 || fail "$command_line: the page is not UTF-8"
# no element but the page's own, and nothing from elsewhere
[ "$(grep -o '</script>' page.html | wc -l)" -eq 2 ] || fail 'names end elements'
! grep -oE '(src|href)=|url\(|@import|https?://[a-z0-9.]*' page.html | grep -vE '^http://www\.(w3|inkscape)\.org$' ||
  fail 'the page needs the network'
for layer in curves regions inner outer ends; do grep -q "$layer: '" page.html || fail "no layer $layer"; done

# Small pages say what they leave out.
few='--stability none --repeat 1 --methods bca'
# shellcheck disable=SC2086
run report --max-size 0.1 $few "$root/examples/data/h_maple_leaf.json" -o small.html
expect_status 0
[ "$(wc -c < small.html)" -lt 110000 ] || fail "$command_line: $(wc -c < small.html) bytes"
grep -q '"drawn":[1-5],' small.html &&
  grep -q '"notes":\["Regions for tolerances below [0-9.e-]* are not drawn' small.html ||
  fail "$command_line: no note of what is left out"
{
  echo '<svg xmlns="http://www.w3.org/2000/svg">'
  for i in {1..3000}; do echo "<path d=\"M$i 0q1.5 2.25 3.125 .75t1 1\"/>"; done
  echo '</svg>'
} > many.svg
# shellcheck disable=SC2086
run report --max-size 0.1 $few --eps 1,0.5 many.svg -o small.html
expect_status 0
[ "$(wc -c < small.html)" -lt 110000 ] || fail "$command_line: $(wc -c < small.html) bytes"
grep -q 'no rows of single curves, of which there are 3000' small.html &&
  grep -q 'Of 3000 curves the first' small.html ||
  fail "$command_line: no note of curves left out"

# refuses STATUS PATTERN ARGUMENTS
refuses() {
  local wanted=$1 pattern=$2
  shift 2
  run report "$@" -o refused.html
  expect_status "$wanted"
  expect_line "bounding_arcs: $pattern"
  expect_silence
  [ ! -e refused.html ] || fail "$command_line: wrote a file"
}
refuses 2 '*eps*' --eps 0 two.svg
refuses 2 '*methods*' --methods abc two.svg
refuses 2 '--points*' --query closest two.svg
refuses 2 '--points*' --points two.svg two.svg
refuses 1 'missing.json*' missing.json
echo '<svg xmlns="http://www.w3.org/2000/svg"><path id="one" d="M0 0L5 1"/></svg>' > open.svg
refuses 1 '*one*open*' --stability none --eps 1 --query locate --points <(echo 1 1) open.svg
refuses 1 'two.svg: curve "one": eps 1e-300*' --stability none --eps 1e-300 two.svg
echo '<svg xmlns="http://www.w3.org/2000/svg"/>' > empty.svg
refuses 1 'empty.svg: *no curve in the drawing*' --stability none empty.svg

browser=$(command -v chromium || command -v chromium-browser)
if [ -z "$browser" ]; then
  echo 'no chromium: the page was not opened'
  finish
fi

# What the page shows, a line each, while a script moves its sliders and switches its layers.
cat > script.html << 'END'
<pre id="log"></pre><script>
const say = (...words) => { document.getElementById('log').textContent += words.join(' ') + '\n'; };
const at = (id) => document.getElementById(id);
const move = (id, value) => { at(id).value = value; at(id).dispatchEvent(new Event('input')); };
window.requestAnimationFrame = (draw) => setTimeout(draw);  // of which a browser without a window has few
const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
const paths = (method, path, letter) =>
  document.querySelector(`.${method} .${path}`).getAttribute('d').split(letter).length - 1;
const methods = ['bca', 'sfa', 'bilens'];
const all = (what) => {
  for (const m of methods) say(what, m, at('count-' + m).dataset.regions, paths(m, 'regions', 'Z'));
};
(async () => {
  try {
    say('tolerances', at('eps').max);
    for (let file = 0; file < 2; ++file) {
      at('file').value = file;
      at('file').dispatchEvent(new Event('change'));
      for (const e of [0, 1]) { move('eps', e); await frame(); all(`file${file} ${at('eps-value').textContent}`); }
      for (let l = 0; l <= at('level').max; ++l) { move('level', l); await frame(); all(`file${file} level${l}`); }
      say(`file${file} rows`, at('table').rows.length, at('table').querySelectorAll('.now').length);
    }
    for (const layer of ['regions', 'inner', 'outer', 'curves', 'ends']) {
      at('layer-' + layer).click(); await frame();
      say('switched', layer, paths('bca', 'regions', 'Z'), paths('bca', 'inner', 'M'), paths('bca', 'outer', 'M'),
          paths('bca', 'curves', 'M'), paths('bca', 'joints', 'M') + paths('bca', 'ends', 'M'));
    }
    const answer = () => document.querySelectorAll('.bca .answers path').length;
    const shown = answer();
    at('layer-answer0').click(); await frame();
    say('answers', shown, answer());
    at('method-sfa').click(); await frame();
    say('hidden', document.querySelectorAll('.panel:not([hidden])').length);
    at('layer-regions').click(); await frame();
    const svg = document.querySelector('.bca svg'), box = svg.getBoundingClientRect();
    const zoomed = async (how) => { await frame(); say('zoomed', how, at('zoom-value').textContent); };
    for (let i = 0; i < 12; ++i) svg.dispatchEvent(new KeyboardEvent('keydown', {key: '+', cancelable: true}));
    await zoomed('keys');
    svg.dispatchEvent(new WheelEvent('wheel', {deltaY: -900, clientX: box.left + 9, clientY: box.top + 9}));
    await zoomed('wheel');
    say('in sight', paths('bca', 'regions', 'Z') < at('count-bca').dataset.regions);
    at('fit').click();
    await zoomed('fit');
    say('in sight', paths('bca', 'regions', 'Z') == at('count-bca').dataset.regions);
    svg.setPointerCapture = () => {};  // of no pointer that is there
    const point = (type, pointerId, x, y) =>
      svg.dispatchEvent(new PointerEvent(type, {pointerId, clientX: box.left + x, clientY: box.top + y}));
    const before = camera.x;
    point('pointerdown', 1, 50, 50);
    point('pointermove', 1, 90, 50);
    say('moved', ((before - camera.x) / camera.span * box.width).toFixed(1));
    point('pointerdown', 2, 90, 150);
    point('pointermove', 2, 90, 250);
    await zoomed('fingers');
    point('pointerup', 1, 90, 50);
    point('pointerup', 2, 90, 250);
    point('pointermove', 1, 0, 0);
    await zoomed('nothing');
    say('elements', document.querySelectorAll('b').length, document.querySelectorAll('option').length);
  } catch (error) { say('error', error); }
  say('end');
})();
</script></body>
END
sed '/^<\/body>$/{
  r script.html
  d
}' page.html > scripted.html
mkdir profile
timeout -k 1 60 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
  --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$PWD/profile" \
  --window-size=1200,900 --virtual-time-budget=20000 --dump-dom "file://$PWD/scripted.html" \
  > "$results/dom" 2> "$results/err" < /dev/null
sed -n '/<pre id="log">/,/^end$/{s/.*<pre id="log">//;p}' "$results/dom" > log
says() { grep -qxE "$1" log || fail "the page does not say: $1; it says: $(grep -E "^${1%% *} " log | head -3)"; }
says 'tolerances 1'
# build's regions, and its spiral segments: those of level 0
file=0
for input_file in "$odd" two.svg; do
  for method in bca sfa bilens; do
    for eps in 0.01 0.0001; do
      run build --method $method --eps $eps "$input_file"
      count=$(grep -c '^{"bezier":' "$results/out")
      says "file$file ${eps/0.0001/1e-4} $method $count $count"
    done
    spirals=$(grep -oE '"spirals":[0-9]+' "$results/out" | awk -F: '{ sum += $2 } END { print sum }')
    says "file$file level0 $method $spirals $spirals"
    last=$(grep "^file$file level.* $method " log | tail -1)
    [ "${last##* }" = "$count" ] || fail "the last level of $method is not its leaves: $last"
  done
  file=$((file + 1))
done
says 'file0 rows 7 3'
says 'file1 rows 7 3'
run build --method bca --eps 0.0001 two.svg
count=$(grep -c '^{"bezier":' "$results/out")
pieces=$(grep -oE '"beziers":[0-9]+' "$results/out" | awk -F: '{ sum += $2 } END { print sum }')
ends=$((count + 2))  # where each starts, and where the two curves end
says "switched regions 0 0 0 $pieces $ends"
says "switched inner 0 $count 0 $pieces $ends"
says "switched outer 0 $count $count $pieces $ends"
says "switched curves 0 $count $count 0 $ends"
says "switched ends 0 $count $count 0 0"
says 'answers 9 6'
says 'hidden 2'
says 'zoomed keys zoom 130'
says 'zoomed wheel zoom 785'
says 'zoomed fit zoom 1'
[ "$(grep -c '^in sight true$' log)" -eq 2 ] || fail 'not what is in sight is drawn'
says 'moved 40.0'
says 'zoomed fingers zoom 2'
says 'zoomed nothing zoom 2'
says 'elements 3 5'
says 'end'
rm -r ./*
finish
