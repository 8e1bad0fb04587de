"""What the README tells a reader to type works: make targets, the Python lines, the C++ lines."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
readme = (ROOT / "README.md").read_text()
makefile = (ROOT / "Makefile").read_text()
blocks = re.findall(r"```(\w+)\n(.*?)```", readme, re.DOTALL)


def code(language):
    return [text for name, text in blocks if name == language]


targets = set(re.findall(r"(?:`|^)make ([a-z][a-z-]*)", readme, re.MULTILINE))
assert {"demo", "test"} <= targets, targets
for target in targets:
    assert re.search(rf"^[a-z -]*\b{target}\b[a-z -]*:", makefile, re.MULTILINE), target
for line in "".join(code("sh")).splitlines():
    assert re.match(r"make [a-z-]+|git clone |cd |cmake |export PYTHONPATH", line), line

# The second piece of Python goes on from the first.
assert len(code("python")) == 2 and len(code("cpp")) == 1
with tempfile.TemporaryDirectory() as folder:
    shutil.copy(ROOT / "Testing" / "Data" / "cubes.vtu", pathlib.Path(folder) / "mesh.vtu")
    script = "\n".join(code("python")) + "\nassert rank.GetNumberOfTuples() == reader.GetOutput().GetNumberOfCells()\n"
    subprocess.run([sys.executable, "-c", script], cwd=folder, env=os.environ, check=True)
    assert (pathlib.Path(folder) / "picture.png").stat().st_size > 5000

# The C++ lines are those of the example, which InstallAndConsume builds and runs.
example = [line.strip() for line in (ROOT / "Examples" / "01_render_a_file.cxx").read_text().splitlines()]
for line in code("cpp")[0].splitlines():
    assert line.strip() in example, line

for name in re.findall(r"\]\(([\w./-]+)\)", readme):
    assert (ROOT / name).exists(), name
