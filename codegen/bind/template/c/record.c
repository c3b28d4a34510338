/*
 * A record that is processed as EPICS processes one: inputs go in, a value comes out, and where there is none, the record is
 * invalid and says why. An aSub routine does the same with its fields A, B, .. and VALA.
 *
 * cc -I../include record.c ../target/release/lib@PREFIX@_c.a -lm -lpthread -ldl
 * ./a.out @COUNT@ numbers, or none for typical ones
 */
#include "@PREFIX@.h"

#include <stdio.h>
#include <stdlib.h>

enum severity { NO_ALARM, INVALID_ALARM };

struct record {
    double inputs[@COUNT@];
    double value;
    enum severity severity;
    char message[256];
};

static long process(struct record *record) {
    const double *inputs = record->inputs;
    @RETURNED@ result;
    @PREFIX@_status status = @CHECKED@(@INPUTS@, &result, record->message, sizeof record->message);
    if (status != @CONSTANT@_OK) {
        record->severity = INVALID_ALARM;
        return -1;
    }
    record->value = result@FIELD@;
    record->severity = NO_ALARM;
    return 0;
}

int main(int count, char **arguments) {
    struct record record = {{@TYPICAL@}, 0.0, INVALID_ALARM, ""};
    int position;
    for (position = 0; position < @COUNT@ && position + 1 < count; ++position) {
        record.inputs[position] = strtod(arguments[position + 1], NULL);
    }
    if (process(&record) != 0) {
        printf("%s: INVALID: %s\n", @NAME@, record.message);
        return EXIT_FAILURE;
    }
    printf("%s: %.17g\n", @NAME@, record.value);
    return EXIT_SUCCESS;
}
