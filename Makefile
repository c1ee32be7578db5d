# Two commands do all set-up on a fresh machine with Python 3.11: make demo, make test.
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)
BIN := .venv/bin
WORKERS ?= 2
# the matrices are small: threads of the linear algebra only wait for one another
export OPENBLAS_NUM_THREADS := 1
# containers often forbid byte code; the tests start some two hundred processes, and each would compile all modules
export PYTHONDONTWRITEBYTECODE :=

.PHONY: help demo test test-all checked derived lint kernels manual bench proof measured clean

help:  ## this list
	@sed -n 's/^\([a-z-]*\):[^#]*## /  make \1#/p' $(MAKEFILE_LIST) | while IFS='#' read -r job does; do \
		printf '%-18s %s\n' "$$job" "$$does"; done

demo: .venv/run  ## find what is concealed in an embedded recording; page and picture in demo/
	$(BIN)/deltacal demo

# Cases of one file share what they diagnose, so a file stays with one worker. WALKS=1 adds what walks through commands.
RUN = $(BIN)/python -m pytest -n $(WORKERS) --dist loadfile --no-loadscope-reorder
ifdef T
test: .venv/dev
	$(RUN) $(addprefix tests/,$(T))
else
test: checked  ## lint, types, import rules, kernels, tests; T=diagnosis: the tests of a folder alone
	$(RUN) $(if $(WALKS),,-m "not thorough and not walk")
endif

test-all: checked  ## the same, with what walks and what takes minutes
	$(BIN)/python -m pytest -n $(WORKERS) -m ""

# types and kernels take half a minute each, of one core
checked: .venv/dev
	$(MAKE) --jobs 2 lint derived

derived: .venv/dev
	$(BIN)/deltacal kernels --check

lint: .venv/dev  ## style, types, who may import whom
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

kernels: .venv/dev  ## derive and emit the kernels
	$(BIN)/deltacal kernels

manual: .venv/dev  ## the manual as a site, in build/manual
	$(BIN)/python -m mkdocs build --strict -f .github/mkdocs.yml

bench: .venv/dev .venv/bench  ## every work beside NumPy, Numba by hand, CasADi and JAX
	$(BIN)/python -m tests.benchmarks
	$(BIN)/python -m tests.benchmarks.scaling
	$(BIN)/python -m tests.benchmarks.motion

proof: .venv/proof  ## conceal effects, diagnose blind, grade: a table and a page in proof/
	$(BIN)/python -m tests.benchmarks.motion_blind --count 20 --kept proof/motion.jsonl --files proof/motion
	$(BIN)/python -m tests.proof -o proof

measured: .venv/dev .venv/bench .venv/proof  ## write the manual's measured tables anew, on an idle machine
	$(BIN)/python -m tests.benchmarks --measured
	$(BIN)/python -m tests.benchmarks.scaling --measured
	$(BIN)/python -m tests.proof -o proof --measured

clean:  ## what the other jobs made
	rm -rf .venv dist demo proof scaling.png .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

.venv/made:
	@test -n "$(PYTHON)" || { echo "deltacal needs Python 3.11 or newer; none was found. Give one: make PYTHON=/path/to/python3"; exit 1; }
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	touch $@

.venv/run: .venv/made pyproject.toml
	$(BIN)/python -m pip install --quiet --editable .
	touch $@

.venv/proof: .venv/run
	$(BIN)/python -m pip install --quiet --editable ".[proof]"
	touch $@

.venv/bench: .venv/run
	$(BIN)/python -m pip install --quiet --editable ".[bench]"
	touch $@

.venv/dev: .venv/run
	$(BIN)/python -m pip install --quiet --group dev
	touch $@
