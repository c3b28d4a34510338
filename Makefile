# Two commands: `make run` makes the kernels, `make test` proves and judges everything. Both install what they need.
# The others are for who changes closedform: CONTRIBUTING.md says when.

CARGO ?= cargo
# the random cases of property tests; another seed tries others
SEED ?= 1

# how long each fuzz target runs
SECONDS_EACH ?= 900

.PHONY: run test test-all bench lowest-rust minimal-versions packages fuzz tools

run: tools
	@echo "building the generator; the first time that takes some minutes, most of them for Symbolica and GMP"
	$(CARGO) build --package closedform-symbolica --package closedform-cli
	$${CARGO_TARGET_DIR:-target}/debug/closedform generate

test: tools
	$(CARGO) test --package closedform-symbolica
	PROPTEST_RNG_SEED=$(SEED) $(CARGO) test --no-fail-fast

# Ten to twenty times as many points as `make test`, and every package by itself.
test-all: test packages
	CLOSEDFORM_BUDGET=full PROPTEST_RNG_SEED=$(SEED) $(CARGO) test --no-fail-fast --package closedform-tests

# What calls cost beside the formulas as they are written: for any processor, then for this one.
bench: tools
	$(CARGO) bench --package closedform-tests --bench ratios
	RUSTFLAGS="-C target-cpu=native" $(CARGO) bench --target-dir target/native --package closedform-tests --bench ratios

# The lowest Rust version that Cargo.toml claims builds everything.
lowest-rust: tools
	version=$$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml) && \
	rustup toolchain install $$version --profile minimal && \
	cargo +$$version check --target-dir target/lowest-rust && \
	cargo +$$version check --target-dir target/lowest-rust --package closedform-symbolica

# The lowest versions of other people's crates that the manifests claim build what others link.
minimal-versions:
	.ci/minimal-versions

# Every crate as it is packed, unpacked and checked by itself.
packages: tools
	.ci/packages

# What the fuzzer finds new goes below target/, what breaks a target below fuzz/artifacts/.
fuzz:
	for target in worksheet contract kernel gcode script cores; do \
		mkdir -p target/fuzz-corpus/$$target && \
		cargo +nightly fuzz run $$target target/fuzz-corpus/$$target fuzz/corpus/$$target -- \
			-max_total_time=$(SECONDS_EACH) -timeout=20 || exit 1; \
	done

# GMP is built from source and needs m4; the judges run the worksheets in Maxima, and ask it for functions of its library
# `stringproc`, which Debian keeps in a package of its own.
tools:
	@missing=; \
	command -v m4 >/dev/null || missing="$$missing m4"; \
	command -v maxima >/dev/null || missing="$$missing maxima"; \
	maxima --very-quiet --batch-string='print(simplode(["string", "proc"]))$$' 2>/dev/null </dev/null \
		| grep -q '^stringproc' || missing="$$missing maxima-share"; \
	test -z "$$missing" && exit 0; \
	if test "$$(id -u)" = 0; then as=; \
	elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then as=sudo; \
	else echo "missing:$$missing. Run: sudo apt-get install --no-install-recommends$$missing" >&2; exit 1; fi; \
	echo "installing$$missing"; \
	$$as apt-get update -qq && \
	$$as env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing >/dev/null
