# Two commands do all set-up on a fresh machine with Python 3.11: make demo, make test.
PYTHON ?= $(shell command -v python3.13 || command -v python3.12 || command -v python3.11 || command -v python3)
BIN := .venv/bin
WORKERS ?= 2
# the matrices are small: threads of the linear algebra only wait for one another
export OPENBLAS_NUM_THREADS := 1

.PHONY: demo test lint kernels bench clean

demo: .venv/run  ## identify the embedded recording, show a table and a picture
	$(BIN)/deltacal demo

test: .venv/dev lint  ## lint, types, import rules, kernels, tests
	$(BIN)/deltacal kernels --check
	$(BIN)/python -m pytest -n $(WORKERS)

lint: .venv/dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

kernels: .venv/dev  ## derive and emit the kernels
	$(BIN)/deltacal kernels

bench: .venv/dev  ## ratios to NumPy on the same work
	$(BIN)/python -m tests.benchmarks

clean:
	rm -rf .venv dist demo .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

.venv/made:
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	touch $@

.venv/run: .venv/made pyproject.toml
	$(BIN)/python -m pip install --quiet --editable .
	touch $@

.venv/dev: .venv/run
	$(BIN)/python -m pip install --quiet --group dev
	touch $@
