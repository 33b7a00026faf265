#!/usr/bin/env bash
# Installs what is missing, builds the tool and the examples, compares the three methods on the bundled curves and draws
# pictures of them into build/pictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh
export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}  # as in test/run.sh
cmake -S . -B build/release -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_TBB=ON > /dev/null
cmake --build build/release --parallel "$(nproc)" --target bounding_arcs bounding_arcs_examples
tool=build/release/src/tool/bounding_arcs
"$tool" compare examples/data/*.json
mkdir -p build/pictures
for method in bca sfa bilens; do
  for curve in examples/data/*.json; do
    picture=build/pictures/$(basename "$curve" .json)_$method.svg
    "$tool" build --method "$method" --eps 0.02 --format svg "$curve" -o "$picture"
  done
done
echo "Pictures are in build/pictures."
