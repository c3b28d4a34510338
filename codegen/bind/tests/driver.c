/* Calls of all kernels, as lines: the tests print a function a kernel below, which writes its columns. */
#include "closedform_kernels.h"
#include "closedform_kernels_tier1.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* More than any kernel has inputs, or rows times results. */
#define ROOM 128
/* What is said of a kernel without a function in C99. */
#define NO_TIER1 (-1)
/* Rows of a batch, all alike. */
#define ROWS 3

static double rows[ROOM][ROWS];

static closedform_kernels_view view(const double *in, int position) {
    closedform_kernels_view view = {rows[position], ROWS};
    int row;
    for (row = 0; row < ROWS; ++row) {
        rows[position][row] = in[position];
    }
    return view;
}

static closedform_kernels_span span(double *out, int position) {
    closedform_kernels_span span = {out + ROWS * position, ROWS};
    return span;
}

/* The last row of results, of which all must be alike. */
static const double *row(double *out, int count) {
    static double last[ROOM];
    int position;
    for (position = 0; position < count; ++position) {
        const double *results = out + ROWS * position;
        last[position] = results[ROWS - 1];
        if (memcmp(results, results + 1, (ROWS - 1) * sizeof(double)) != 0) {
            printf("rows differ: ");
        }
    }
    return last;
}

static void print(const double *values, int count) {
    int position;
    for (position = 0; position < count; ++position) {
        uint64_t bits;
        memcpy(&bits, &values[position], sizeof bits);
        printf("%s", position > 0 ? " " : "");
        if (values[position] != values[position]) {
            printf("nan");
        } else {
            printf("%016" PRIx64, bits);
        }
    }
    printf("\t");
}

static int answer(void (*const calls[])(const double *), const int counts[]) {
    int kernel, position;
    while (scanf("%d", &kernel) == 1) {
        double in[ROOM];
        for (position = 0; position < counts[kernel]; ++position) {
            uint64_t bits;
            if (scanf("%" SCNx64, &bits) != 1) {
                return 1;
            }
            memcpy(&in[position], &bits, sizeof bits);
        }
        calls[kernel](in);
    }
    return 0;
}
