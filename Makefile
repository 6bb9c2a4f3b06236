# Every target sets up what it needs: a virtual environment in .venv, with the exact versions of constraints.txt.

PYTHON ?= python3
# Those that the classifiers of pyproject.toml name; the workflows try the next one, too.
PYTHONS ?= python3.11 python3.12 python3.13
ORDERS ?= 1 2 3 4 5
MUTANTS ?=
SPHINX ?=
SANITIZE ?=
WORKERS ?= auto
MARKS ?= slow
ENGINE ?= chromium
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
READY := $(VENV)/.ready

.PHONY: demo core test test-slow test-orders test-versions dist dist-tests mutants campaign campaign-all browser verify sanitize lint docs bench docs-numbers clean

demo: $(INSTALLED)
	$(BIN)/nonhertz solve examples/cylindrical-roller-bearing.toml --out out/demo
	@echo "Figures, table and result are in out/demo; open out/demo/pressure.svg first."

# Compiles what has changed of the core, in seconds; every other target takes it as it is.
core: $(READY)
	$(BIN)/cmake --build build
	$(BIN)/python build-tools/stub.py

# Workers share the cores: linear algebra has one thread in each. A file is one worker's: what its tests share is solved
# once.
test test-slow campaign: export OMP_NUM_THREADS = 1

test: $(READY)
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadfile -m "not slow and not campaign and not browser"

# The tests that take seconds each, which `make test` leaves out.
test-slow: $(READY)
	$(BIN)/python -m pytest -n auto --dist loadfile -m "($(MARKS)) and not browser"

# The same tests in other orders, one for each number.
test-orders: $(READY)
	for order in $(ORDERS); do \
	  $(BIN)/python -m pytest -n auto --random-order --random-order-seed=$$order || exit 1; \
	done

# The lowest and the newest versions of what the package needs, on every Python; says which Pythons are not there.
test-versions: $(READY)
	$(BIN)/python -m pip install --quiet --constraint constraints.txt --group versions
	$(BIN)/python tests/versions.py $(PYTHONS)

# Wheel and sdist in dist, used in bare environments of every Python; dist-tests runs the tests of the sdist there, too.
dist dist-tests: $(READY)
	$(BIN)/python -m pip install --quiet --constraint constraints.txt --group dist
	$(BIN)/python tests/distributions.py $(PYTHONS) $(if $(filter dist-tests,$@),--tests)

# Whether the tests notice small mistakes in the sources, C++ and Python; survivors are listed in out/mutants. Takes three
# hours on two cores, of some rooms less: make mutants MUTANTS="--rooms core/grids files".
mutants: $(READY)
	$(BIN)/python tests/mutation/run.py $(MUTANTS) --out out/mutants

campaign: $(READY)
	$(BIN)/python -m pytest -n auto --dist loadfile -rP -m campaign tests

# Many hours of one core: the campaigns whole, 50,000 extreme contacts and 20,000 real rollers among them.
campaign-all: $(READY)
	NONHERTZ_CAMPAIGN_CASES=all $(BIN)/python -m pytest -m campaign -s tests

# The page in a real browser: Chromium or Chrome, with ENGINE=firefox Firefox, which must be installed. Screenshots go to
# out/screenshots.
browser: $(READY)
	NONHERTZ_ENGINE=$(ENGINE) $(BIN)/python -m pytest -m browser -s tests/browser

verify: $(READY)
	PYTHONPATH=tests $(BIN)/python -m claims out/verify

# Tests on builds of the core that look for mistakes in memory and for races; SANITIZE=--short runs a few.
sanitize: $(READY)
	$(BIN)/python tests/core/sanitized.py $(SANITIZE)

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/mypy --platform win32
	$(BIN)/lint-imports
	$(BIN)/cmake --build build
	$(BIN)/python build-tools/stub.py --check
	$(BIN)/clang-format --dry-run -Werror src/core/*/*.[ch]pp src/bindings/*.[ch]pp

docs: $(READY)
	$(BIN)/python -m pip install --quiet --constraint constraints.txt --group docs
	$(BIN)/python -m sphinx $(SPHINX) --fail-on-warning --keep-going --quiet --builder html docs out/site
	@echo "The documents are in out/site; open out/site/index.html first."

# The race runs without the peers where they cannot be had, and says so.
bench: $(READY)
	-$(BIN)/python -m pip install --quiet --constraint constraints.txt --group peers
	-$(BIN)/python -m pip install --quiet --constraint constraints.txt --group built-peers
	$(BIN)/python benchmarks/report.py
	$(BIN)/python benchmarks/race.py
	$(BIN)/python benchmarks/page.py
	$(BIN)/python benchmarks/stopwatch.py
	$(BIN)/python benchmarks/bearings.py
	$(BIN)/python benchmarks/gradients.py
	$(BIN)/python benchmarks/studies.py
	$(BIN)/python paper/figures.py

docs-numbers: $(READY)
	$(BIN)/python docs/figures.py
	$(BIN)/python docs/screenshots.py
	$(BIN)/python docs/grid_study.py
	$(BIN)/python docs/end_study.py
	$(BIN)/python docs/model_study.py
	$(BIN)/python docs/patch_study.py
	PYTHONPATH=tests $(BIN)/python docs/validation_pages.py
	$(BIN)/python paper/figures.py

# What a user has: the package with its page, from these sources, and nothing of a developer's.
$(INSTALLED): pyproject.toml constraints.txt CMakeLists.txt
	@echo "Setting up $(VENV), which takes a minute or two; the next time it is there."
	$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --upgrade --constraint constraints.txt pip
	@echo "Compiling the core, and installing what the command line, the figures and the page need."
	@$(BIN)/python build-tools/compiler.py >/dev/null
	@$(BIN)/python -m pip install --quiet --constraint constraints.txt --build-constraint constraints.txt --editable ".[web]"
	@touch $@

# What the tests and linters need, and the build's own tools: from now on only what has changed is compiled.
$(READY): $(INSTALLED)
	@echo "Installing what tests and linters need."
	@$(BIN)/python -m pip install --quiet --constraint constraints.txt --group dev $$($(BIN)/python build-tools/compiler.py)
	@$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@

clean:
	rm -rf $(VENV) dist out docs/gallery docs/reference/api/classes build src/nonhertz/_core*.so src/nonhertz/_core*.pyd
