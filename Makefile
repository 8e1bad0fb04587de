# Each target does all set-up itself; a second run does nothing twice.
.PHONY: build demo test bench report pythonpath clean test-newest
.DEFAULT_GOAL := build

# The Python that Debian's VTK is wrapped for, whatever python3 comes first on PATH.
python := /usr/bin/python3
pythonpath := $(CURDIR)/build/lib/python3/dist-packages
offscreen := Module/offscreen.sh
benchmark := build/bin/CellProjectionBenchmark

CELLPROJECTION_DATA ?= $(abspath $(wildcard ../shared/data))
ifneq ($(CELLPROJECTION_DATA),)
export CELLPROJECTION_DATA
endif

build:
	@Module/setup.sh
	cmake -S Module -B build $(if $(wildcard build/CMakeCache.txt),,-G Ninja) \
	  -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE=$(python)
	cmake --build build

demo: build
	@PYTHONPATH="$(pythonpath)" $(offscreen) $(python) Examples/01_render_a_file.py

test: build
	cd build && ../$(offscreen) ctest --output-on-failure -j 2

bench: build
	@$(offscreen) $(benchmark)

# Short for now: the benchmark's table, kept in a file.
report: build
	@mkdir -p build/report
	@$(offscreen) $(benchmark) > build/report/report.txt && cat build/report/report.txt
	@echo "$(CURDIR)/build/report/report.txt"

pythonpath:
	@echo "$(pythonpath)"

test-newest:
	@echo "test-newest: not there yet"; exit 1

clean:
	rm -rf build
