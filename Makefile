# Two commands: `make run` makes the kernels, `make test` proves and judges everything. Both install what they need.

CARGO ?= cargo
# the random cases of property tests; another seed tries others
SEED ?= 1

.PHONY: run test tools

run: tools
	@echo "building the generator; the first time that takes some minutes, most of them for Symbolica and GMP"
	$(CARGO) build --package closedform-symbolica
	$(CARGO) run --package closedform-cli -- generate

test: tools
	$(CARGO) test --package closedform-symbolica
	PROPTEST_RNG_SEED=$(SEED) $(CARGO) test --no-fail-fast

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
