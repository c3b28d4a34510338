/*
 * The arithmetic of tier 1: doubles and pairs of them, as closedform computes them in Rust, operation by operation. `escalate` is
 * raised where a step may not be what it promises.
 */
#ifndef @CONSTANT@_ARITHMETIC_H
#define @CONSTANT@_ARITHMETIC_H

#include <float.h>
#include <math.h>
#include <stddef.h>

/* Every operation rounds once, by itself: otherwise nothing that is said here holds. */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "doubles are computed in another precision: use SSE2 or the like (-msse2 -mfpmath=sse)"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "compile without -ffast-math and its parts"
#endif
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "double is not the binary64 of IEEE 754"
#endif
#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#else
#pragma GCC optimize("fp-contract=off")
#endif

/* 2^-450 and 2^450: between them a step in double-double loses no digits. */
#define CF_LEAST 0x1p-450
#define CF_MOST 0x1p+450
/* The largest factor that can be split. */
#define CF_LARGEST_FACTOR 0x1p+996

/* A number of about 106 bits: the sum of both. */
typedef struct cf_dd {
    double high;
    double low;
} cf_dd;

/* A compensated expression: two numbers that add up to it, the second one of any size, and the sum of the magnitudes of its
   terms. */
typedef struct cf_sum {
    cf_dd pair;
    double size;
} cf_sum;

/* Whether a number is 0 or of a magnitude at which no step over- or underflows. */
static inline int cf_ordinary(double x, double least, double most) {
    return (x == 0.0) | ((fabs(x) >= least) & (fabs(x) <= most));
}

static inline int cf_is_finite(double x) {
    return fabs(x) <= DBL_MAX;
}

/* Conditions of which both sides are evaluated, whatever the first one is. */

static inline int cf_both(int left, int right) {
    return left & right;
}

static inline int cf_either(int left, int right) {
    return left | right;
}

/* Doubles. */

static inline double cf_divide(double a, double b, unsigned *escalate) {
    *escalate |= (unsigned)!(b != 0.0);
    return a / b;
}

static inline double cf_sqrt(double x, unsigned *escalate) {
    *escalate |= (unsigned)!(x >= 0.0);
    return sqrt(x);
}

static inline double cf_abs(double x, unsigned *escalate) {
    (void)escalate;
    return fabs(x);
}

static inline double cf_larger(double best, double next) {
    return next > best ? next : best;
}

static inline double cf_smaller(double best, double next) {
    return next < best ? next : best;
}

/* Error-free transformations: Knuth's sum, Dekker's sum and product. */

static inline cf_dd cf_two_sum(double a, double b) {
    double high = a + b;
    double a_part = high - b;
    double b_part = high - a_part;
    cf_dd sum = {high, (a - a_part) + (b - b_part)};
    return sum;
}

static inline cf_dd cf_fast_two_sum(double a, double b) {
    double high = a + b;
    cf_dd sum = {high, b - (high - a)};
    return sum;
}

static inline cf_dd cf_split(double x) {
    double scaled = 134217729.0 * x; /* 2^27 + 1 */
    double high = scaled - (scaled - x);
    cf_dd halves = {high, x - high};
    return halves;
}

static inline cf_dd cf_two_product(double a, double b) {
    double high = a * b;
    cf_dd x = cf_split(a), y = cf_split(b);
    cf_dd product = {high, x.low * y.low - (((high - x.high * y.high) - x.low * y.high) - x.high * y.low)};
    return product;
}

/* Double-double without a look at ranges. */

static inline cf_dd cf_exact(double x) {
    cf_dd exact = {x, 0.0};
    return exact;
}

static inline cf_dd cf_dd_negate(cf_dd x) {
    cf_dd negative = {-x.high, -x.low};
    return negative;
}

static inline cf_dd cf_plus(cf_dd x, cf_dd y) {
    cf_dd high = cf_two_sum(x.high, y.high);
    cf_dd low = cf_two_sum(x.low, y.low);
    cf_dd sum = cf_fast_two_sum(high.high, high.low + low.high);
    return cf_fast_two_sum(sum.high, low.low + sum.low);
}

static inline cf_dd cf_times_exact(cf_dd x, double y) {
    cf_dd product = cf_two_product(x.high, y);
    cf_dd sum = cf_fast_two_sum(product.high, x.low * y);
    return cf_fast_two_sum(sum.high, sum.low + product.low);
}

static inline cf_dd cf_times(cf_dd x, cf_dd y) {
    cf_dd product = cf_two_product(x.high, y.high);
    double cross = x.high * y.low + x.low * y.high;
    return cf_fast_two_sum(product.high, product.low + cross);
}

/* Double-double as the arithmetic of a program: a step that leaves the range escalates. */

static inline cf_dd cf_in_range(cf_dd x, int may_vanish, unsigned *escalate) {
    double size = fabs(x.high);
    int inside = ((size >= CF_LEAST) & (size <= CF_MOST)) | (may_vanish & (size == 0.0));
    *escalate |= (unsigned)!inside;
    return x;
}

static inline cf_dd cf_dd_input(double x, unsigned *escalate) {
    return cf_in_range(cf_exact(x), 1, escalate);
}

static inline cf_dd cf_dd_literal(double x, unsigned *escalate) {
    *escalate |= (unsigned)(fabs(x) > CF_LARGEST_FACTOR);
    return cf_exact(x);
}

static inline cf_dd cf_dd_pi(void) {
    return cf_two_sum(3.141592653589793, 1.2246467991473532e-16);
}

static inline cf_dd cf_dd_add(cf_dd x, cf_dd y, unsigned *escalate) {
    return cf_in_range(cf_plus(x, y), 1, escalate);
}

static inline cf_dd cf_dd_subtract(cf_dd x, cf_dd y, unsigned *escalate) {
    return cf_in_range(cf_plus(x, cf_dd_negate(y)), 1, escalate);
}

static inline cf_dd cf_dd_multiply(cf_dd x, cf_dd y, unsigned *escalate) {
    return cf_in_range(cf_times(x, y), (x.high == 0.0) | (y.high == 0.0), escalate);
}

static inline cf_dd cf_dd_divide(cf_dd x, cf_dd y, unsigned *escalate) {
    double quotient = x.high / y.high;
    cf_dd product = cf_times_exact(y, quotient);
    double rest = (x.high - product.high) + (x.low - product.low);
    return cf_in_range(cf_fast_two_sum(quotient, rest / y.high), x.high == 0.0, escalate);
}

static inline cf_dd cf_dd_sqrt(cf_dd x, unsigned *escalate) {
    double root = sqrt(x.high);
    cf_dd square = cf_two_product(root, root);
    double remainder = (x.high - square.high) - square.low;
    double correction = (x.low + remainder) / (2.0 * root);
    return cf_in_range(root == 0.0 ? x : cf_fast_two_sum(root, correction), 1, escalate);
}

static inline cf_dd cf_dd_abs(cf_dd x, unsigned *escalate) {
    (void)escalate;
    return x.high < 0.0 ? cf_dd_negate(x) : x;
}

static inline int cf_dd_less(cf_dd x, cf_dd y) {
    return (x.high < y.high) | ((x.high == y.high) & (x.low < y.low));
}

static inline int cf_dd_equal(cf_dd x, cf_dd y) {
    return (x.high == y.high) & (x.low == y.low);
}

static inline int cf_dd_less_or_equal(cf_dd x, cf_dd y) {
    return cf_dd_less(x, y) | cf_dd_equal(x, y);
}

static inline cf_dd cf_dd_larger(cf_dd best, cf_dd next) {
    return cf_dd_less(best, next) ? next : best;
}

static inline cf_dd cf_dd_smaller(cf_dd best, cf_dd next) {
    return cf_dd_less(next, best) ? next : best;
}

/* Compensated expressions. */

static inline cf_sum cf_sum_of(double a, double b) {
    cf_sum sum = {cf_two_sum(a, b), fabs(a) + fabs(b)};
    return sum;
}

static inline cf_sum cf_product_of(double a, double b) {
    cf_dd product = cf_two_product(a, b);
    cf_sum sum = {product, fabs(product.high)};
    return sum;
}

static inline cf_sum cf_sum_negate(cf_sum x) {
    cf_sum negative = {cf_dd_negate(x.pair), x.size};
    return negative;
}

static inline cf_sum cf_sum_plus_exact(cf_sum x, double y) {
    cf_sum sum = {cf_two_sum(x.pair.high, y), x.size + fabs(y)};
    sum.pair.low = x.pair.low + sum.pair.low;
    return sum;
}

static inline cf_sum cf_sum_plus(cf_sum x, cf_sum y) {
    cf_sum sum = {cf_two_sum(x.pair.high, y.pair.high), x.size + y.size};
    sum.pair.low = (x.pair.low + y.pair.low) + sum.pair.low;
    return sum;
}

static inline cf_sum cf_sum_times_exact(cf_sum x, double y) {
    cf_sum product = {cf_two_product(x.pair.high, y), x.size * fabs(y)};
    double low = x.pair.low * y;
    product.pair.low = low + product.pair.low;
    return product;
}

static inline cf_sum cf_sum_times(cf_sum x, cf_sum y) {
    cf_sum product = {cf_two_product(x.pair.high, y.pair.high), x.size * y.size};
    double left = x.pair.high * y.pair.low;
    double right = x.pair.low * y.pair.high;
    product.pair.low = (left + right) + product.pair.low;
    return product;
}

/* A product with a power of two, which rounds nothing. */
static inline cf_sum cf_scaled(double a, double power) {
    double product = a * power;
    cf_sum sum = {{product, -0.0}, fabs(product)};
    return sum;
}

static inline cf_sum cf_sum_scaled(cf_sum x, double power) {
    cf_sum product = {{x.pair.high * power, x.pair.low * power}, x.size * fabs(power)};
    return product;
}

/* The value rounded; zero is positive. */
static inline double cf_sum_round(cf_sum x) {
    double value = x.pair.high + x.pair.low;
    return value + 0.0;
}

/* The same as a number of about 106 bits. */
static inline cf_dd cf_sum_dd(cf_sum x) {
    double high = x.pair.high + 0.0;
    return cf_two_sum(high, x.pair.low);
}

/* Whether its digits are right; where they are not, finer tiers sum exactly. */
static inline int cf_is_settled(cf_sum x, double threshold) {
    return fabs(cf_sum_round(x)) >= threshold * x.size;
}

static inline double cf_compensated(cf_sum x, double threshold, unsigned *escalate) {
    *escalate |= (unsigned)!cf_is_settled(x, threshold);
    return cf_sum_round(x);
}

static inline cf_dd cf_dd_compensated(cf_sum x, double threshold, unsigned *escalate) {
    *escalate |= (unsigned)!cf_is_settled(x, threshold);
    return cf_in_range(cf_sum_dd(x), 1, escalate);
}

static inline double cf_residual(cf_sum x, unsigned *escalate) {
    (void)escalate;
    return cf_sum_round(x);
}

static inline cf_dd cf_dd_residual(cf_sum x, unsigned *escalate) {
    *escalate |= (unsigned)!cf_is_finite(x.size);
    return cf_in_range(cf_sum_dd(x), 1, escalate);
}

#endif
