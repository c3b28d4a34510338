/* What callers do wrong, and many threads at once; says each status and text, a line each. */
#include "closedform_kernels.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#define ROWS 1000
#define THREADS 4

typedef closedform_kernels_view view;
typedef closedform_kernels_span span;

static double inputs[4][ROWS], results[ROWS];

static view at(int input, size_t length) {
    view view = {inputs[input], length};
    return view;
}

static void say(const char *what, int status, const char *text) {
    printf("%s: %d: %s\n", what, status, text);
}

static void batch(const char *what, view first, view second, span result) {
    char text[200] = "stale";
    int status = closedform_kernels_turnaround_t_in_batch(first, second, at(2, first.length), at(3, first.length), result,
                                                          text, sizeof text);
    say(what, status, text);
}

static void arrays(void) {
    span good = {results, ROWS}, null = {NULL, ROWS}, same = {inputs[1] + 10, ROWS}, nothing = {NULL, 0}, huge;
    view odd, none = {NULL, ROWS}, empty = {NULL, 0}, endless;
    odd.data = (const double *)(const void *)((const char *)inputs[0] + 1);
    odd.length = ROWS - 1;
    endless.data = inputs[0];
    endless.length = (size_t)-1;
    huge.data = results;
    huge.length = (size_t)-1 / 8;
    batch("good", at(0, ROWS), at(1, ROWS), good);
    batch("nothing", empty, empty, nothing);
    batch("null input", none, at(1, ROWS), good);
    batch("null result", at(0, ROWS), at(1, ROWS), null);
    batch("misaligned", odd, at(1, ROWS), good);
    batch("short input", at(0, ROWS), at(1, ROWS - 1), good);
    batch("overlap", at(0, ROWS), at(1, ROWS), same);
    batch("endless", endless, at(1, ROWS), good);
    batch("huge", at(0, ROWS), at(1, ROWS), huge);
    {
        static double both[2 * ROWS];
        char text[200];
        span one = {both, ROWS}, other = {both + ROWS - 1, ROWS}, third = {results, ROWS};
        int status = closedform_kernels_turnaround_outer_ramp_batch(at(0, ROWS), at(1, ROWS), at(2, ROWS), at(3, ROWS), one,
                                                                    third, other, text, sizeof text);
        say("results overlap", status, text);
    }
}

static void numbers(void) {
    char text[200] = "stale", small[12];
    double result = 7.0;
    union {
        double aligned[2];
        char bytes[2 * sizeof(double)];
    } place;
    int status = closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.002, &result, text, sizeof text);
    say("checked", status, text);
    printf("%.17g\n", result);
    result = 7.0;
    status = closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.0, &result, text, sizeof text);
    say("outside", status, text);
    status = closedform_kernels_turnaround_t_in_checked(NAN, 0.028, 2.0, 0.002, &result, text, sizeof text);
    say("not a number", status, text);
    status = closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.0, &result, small, sizeof small);
    say("little room", status, small);
    say("no room", closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.0, &result, small, 0), "as it was");
    say("no text", closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.0, &result, NULL, 99), "");
    printf("untouched: %g\n", result);
    status = closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.002, NULL, text, sizeof text);
    say("null", status, text);
    status = closedform_kernels_turnaround_t_in_checked(0.002, 0.028, 2.0, 0.002,
                                                        (double *)(void *)(place.bytes + 1), text, sizeof text);
    say("misaligned", status, text);
}

static void information(void) {
    const closedform_kernels_info *info = closedform_kernels_turnaround_t_in_info();
    size_t position;
    for (position = 0; position < closedform_kernels_count(); ++position) {
        if (closedform_kernels_at(position) == info) {
            printf("found: %s\n", info->name);
        }
    }
    printf("beyond: %d\n", closedform_kernels_at(position) == NULL);
    printf("%s: %lu inputs, %s [%s], %lu conditions, %s, bound %g\n", info->summary, (unsigned long)info->input_count,
           info->inputs[3].worksheet, info->inputs[3].unit, (unsigned long)info->domain_count, info->domain[0],
           info->results[0].bound_ulp);
}

static void *thread(void *own) {
    double *results = own;
    char text[200];
    int round;
    for (round = 0; round < 20; ++round) {
        span result = {results, ROWS};
        if (closedform_kernels_turnaround_t_in_batch(at(0, ROWS), at(1, ROWS), at(2, ROWS), at(3, ROWS), result, text,
                                                     sizeof text) != CLOSEDFORM_KERNELS_OK) {
            return NULL;
        }
    }
    return own;
}

static void threads(void) {
    static double own[THREADS][ROWS];
    pthread_t threads[THREADS];
    int position, same = 0;
    for (position = 0; position < THREADS; ++position) {
        pthread_create(&threads[position], NULL, thread, own[position]);
    }
    for (position = 0; position < THREADS; ++position) {
        void *returned;
        pthread_join(threads[position], &returned);
        same += returned != NULL && memcmp(own[position], results, sizeof results) == 0;
    }
    printf("threads: %d\n", same);
}

int main(void) {
    int row;
    for (row = 0; row < ROWS; ++row) {
        inputs[0][row] = 0.002 + 1e-6 * row;
        inputs[1][row] = 0.028;
        inputs[2][row] = 2.0;
        inputs[3][row] = 0.002;
    }
    arrays();
    numbers();
    information();
    batch("again", at(0, ROWS), at(1, ROWS), (span){results, ROWS});
    threads();
    return 0;
}
