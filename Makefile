# Each target does all set-up itself; a second run does nothing twice.
.PHONY: build demo test bench report pythonpath clean test-newest sanitize
.DEFAULT_GOAL := build

# Two stacks may build one tree: make test-newest has a folder of its own.
BUILD := build
# Which tests: LABEL=core takes those that a change must pass in minutes, WITHOUT=windowless those that open windows.
LABEL :=
WITHOUT :=
# Which of them make test-newest runs in OSMesa's windows: LABEL's, or window for those that show what a window may break.
OSMESA_LABEL :=
CMAKE_OPTIONS :=

# The Python that Debian's VTK is wrapped for, whatever python3 comes first on PATH.
python := /usr/bin/python3
pythonpath := $(CURDIR)/$(BUILD)/lib/python3/dist-packages
offscreen := $(BUILD)/offscreen.sh
benchmark := $(BUILD)/bin/CellProjectionBenchmark

CELLPROJECTION_DATA ?= $(abspath $(wildcard ../shared/data))
ifneq ($(CELLPROJECTION_DATA),)
export CELLPROJECTION_DATA
endif

build:
	@Module/setup.sh
	cmake -S Module -B $(BUILD) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-G Ninja) \
	  -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE=$(python) $(CMAKE_OPTIONS)
	cmake --build $(BUILD)

demo: build
	@PYTHONPATH="$(pythonpath)" $(offscreen) $(python) Examples/01_render_a_file.py

test: build
	cd $(BUILD) && ./offscreen.sh ctest --output-on-failure --no-tests=error -j 2 \
	  $(if $(LABEL),-L '^$(LABEL)$$') $(if $(WITHOUT),-LE '^$(WITHOUT)$$')

# BENCH: a section alone (mappers, scaling, tiles, instructions, sorts, ...), or all; BENCH_FOLDER is where the table and the plots
# of scaling go.
BENCH ?= all
BENCH_FRAMES ?= 9
BENCH_FOLDER ?= docs/bench
bench: build
	@mkdir -p $(BENCH_FOLDER)
	@$(offscreen) $(benchmark) $(BENCH_FRAMES) $(BENCH) $(BENCH_FOLDER)
	@$(if $(filter all scaling,$(BENCH)),$(python) Testing/Benchmark/scaling.py $(BENCH_FOLDER))

# Speed against error: REPORT=full takes up to 40 minutes, quick 5; REPORT_FOLDER is where it goes.
REPORT ?= full
REPORT_FOLDER ?= docs/report
report: build
	@mkdir -p $(REPORT_FOLDER)
	@$(offscreen) $(BUILD)/bin/CellProjectionReport $(REPORT_FOLDER)/report.csv $(REPORT)
	@$(python) Testing/Benchmark/report.py $(REPORT_FOLDER)

pythonpath:
	@echo "$(pythonpath)"

# The same sources and tests in a root of Debian's testing release, with EGL, then OSMesa.
test-newest:
	@CMAKE_OPTIONS="$(CMAKE_OPTIONS)" Module/NewestVTK/test.sh "$(LABEL)" "$(OSMESA_LABEL)"

# The kernels of the Tiles engines and their tests with ThreadSanitizer and AddressSanitizer.
sanitize:
	@Module/setup.sh
	@Module/sanitize.sh

clean:
	rm -rf build build-newest build-sanitize-thread build-sanitize-address
