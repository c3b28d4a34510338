/*
 * A task of a controller without an operating system, such as a Cortex-M: called once a cycle, it allocates nothing and never
 * waits. It needs no headers but those of the compiler.
 *
 * rustup target add thumbv7em-none-eabihf
 * cargo rustc --profile small --no-default-features --target thumbv7em-none-eabihf --crate-type staticlib
 * arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -Iinclude -c examples/controller.c
 */
#include "@PREFIX@.h"

/* What sensors write and drives read. */
volatile double controller_inputs[@COUNT@] = {@TYPICAL@};
volatile double controller_output;
volatile int controller_fault;

void controller_cycle(void) {
    double inputs[@COUNT@];
    @RETURNED@ result;
    int position;
    for (position = 0; position < @COUNT@; ++position) {
        inputs[position] = controller_inputs[position];
    }
    result = @CALL@(@INPUTS@);
    /* NaN outside the domain, which is not equal to itself */
    controller_fault = result@FIELD@ != result@FIELD@;
    if (!controller_fault) {
        controller_output = result@FIELD@;
    }
}
