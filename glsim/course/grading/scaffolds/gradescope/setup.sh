#!/usr/bin/env bash
# Runs once, as root, when Gradescope builds the image: installs glsim and what it draws and isolates with.
set -euo pipefail
base=${AUTOGRADER:-/autograder}
apt-get update -q
apt-get install -y -q --no-install-recommends bubblewrap libegl1 libgl1 libgl1-mesa-dri python3-venv
python3 -m venv "$base/venv"
wheel=$(find "$base/source" -maxdepth 1 -name 'glsim-*.whl' -print -quit)
"$base/venv/bin/python" -m pip install -q "${wheel:-glsim==@VERSION@}"
"$base/venv/bin/glsim" doctor
