# Two commands do everything on a machine with Python 3.11 and a C compiler: make demo, make test.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
BEDS := $(basename $(notdir $(wildcard testbeds/*.toml)))

.PHONY: demo test check check-style generated validation bench bench-box bench-governor clean

# Emit, compile and run the shipped differential bed, and draw the result.
demo: $(VENV)/demo
	mkdir -p demo
	$(BIN)/ptgen generate testbeds/differential.toml -o demo/differential
	$(BIN)/ptgen modal testbeds/differential.toml --lock diff.limited_slip --plot demo/modes.svg
	$(BIN)/ptgen simulate testbeds/differential.toml --scenario scenarios/differential-speed-ramps.toml \
	  -o demo/run.csv --plot demo/run.svg
	$(BIN)/ptgen simulate testbeds/differential.toml --scenario scenarios/differential-speed-ramps.toml \
	  --controller conventional --plot demo/conventional.svg
	@echo "look at demo/run.svg, demo/conventional.svg and demo/modes.svg; the C is in demo/differential"

test: $(VENV)/test
	$(BIN)/python -m pytest -n auto

# Everything that is checked before a commit.
check: check-style test

check-style: $(VENV)/dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/python docs/make_equations.py --check
	$(BIN)/clang-format --dry-run -Werror generated/*/*.h generated/*/*_support.c generated/*/*_run.c generated/*/*_main.c

# Emit the committed projects anew.
generated: $(VENV)/demo
	for bed in $(BEDS); do rm -rf generated/$$bed && $(BIN)/ptgen generate testbeds/$$bed.toml -o generated/$$bed || exit 1; done

# Run the comparisons with the source anew and write docs/validation.md, its figures and its numbers.
validation: $(VENV)/demo
	$(BIN)/python docs/make_validation.py

bench: $(VENV)/test
	$(BIN)/python bench/run.py
	$(BIN)/python bench/controller.py
	$(BIN)/python bench/solver.py
	$(BIN)/python bench/governor_kernels.py
	$(BIN)/python bench/accuracy.py
	$(BIN)/python bench/simulators.py

# Ten million random friction problems for each number of elements: about an hour.
bench-box: $(VENV)/test
	$(BIN)/python bench/box.py

# The optimal governor against all rows of its horizon, 100 000 steps and 10 000 states: some ten minutes.
bench-governor: $(VENV)/test
	$(BIN)/python bench/governor_sweep.py

$(VENV)/demo: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --editable .
	touch $@

$(VENV)/test: pyproject.toml | $(VENV)/demo
	$(BIN)/pip install --quiet --editable ".[test]"
	touch $@

$(VENV)/dev: pyproject.toml | $(VENV)/demo
	$(BIN)/pip install --quiet --editable ".[dev]"
	touch $@

clean:
	rm -rf $(VENV) demo
