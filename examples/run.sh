#!/usr/bin/env bash
# Installs what is missing, builds the tool and the examples and all that `cmake --install build/release` installs,
# compares the three methods on the bundled curves, and draws pictures into build/pictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh
export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}  # as in test/run.sh
cmake -S . -B build/release -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_TBB=ON > /dev/null
cmake --build build/release --parallel "$(nproc)" \
  --target bounding_arcs bounding_arcs_manual bounding_arcs_examples
tool=build/release/src/tool/bounding_arcs data=examples/data
"$tool" compare $data/*.json

# draw NAME WHAT ARGUMENTS: what the tool draws with these arguments, and a line that says what that is.
draw() {
  local picture=build/pictures/$1.svg what=$2
  shift 2
  "$tool" "$@" --format svg -o "$picture"
  echo "$picture: $what"
}
mkdir -p build/pictures/mount
echo 'Pictures:'
# First those of the recipe, from a part to tool paths; its G-code is beside them.
bash examples/part_to_tool_path.sh "$tool" build/pictures/mount > build/pictures/mount/commands.txt
sed -n 's|^!\[\(.*\)](images/mount_\(.*\))$|build/pictures/mount/\2: \1|p' doc/tool.md
draw pocket 'insets of a bracket, every 2 mm, around its holes as islands' \
  offset --distance -2,-4,-6,-8,-10,-12,-14,-16,-18 --eps 0.01 $data/bracket.svg
draw axis 'the medial axis of the bracket, with the discs of its vertices' \
  medial-axis --eps 0.01 --discs $data/bracket.svg
draw thickness 'the thickness of the bracket in colour, and its necks' thickness --eps 0.01 $data/bracket.svg
draw leaf_axis 'the medial axis of a leaf, with discs' medial-axis --eps 1e-4 --discs $data/h_maple_leaf.json
draw cat_thickness 'the thickness of a cat' thickness --eps 1e-4 $data/e_cat.json
draw union 'the union of a rabbit and a cat' boolean union $data/d_rabbit.json $data/e_cat.json
for method in bca sfa bilens; do
  draw loop_$method "a looping cubic in regions 0.3 thick, by $method" \
    build --method $method --eps 0.3 doc/images/loop.json
done
