/* Measures the cost of a step through the C interface: by one call per step, and by one call for many steps of the same ball, which is the library's own loop. */
#define _POSIX_C_SOURCE 200809L
#include <football_physics.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { STEPS = 100, ROUNDS = 40000 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void check(fp_status status)
{
    if (status != FP_OK) { fprintf(stderr, "%s\n", fp_last_error()); exit(1); }
}

int main(int argc, char **argv)
{
    const char *json = argc > 1 ? argv[1] : "{}";
    double position[3] = { 0, 1, 0 }, velocity[3] = { 3, 9, -24 }, spin[3] = { 0, 40, 0 }, by_call = 1e9, by_many = 1e9, with_events = 1e9;
    fp_scene *scene;
    fp_state kick, state;
    fp_event events[16];
    int32_t count;
    int round, i;
    check(FOOTBALL_CHECK_ABI());
    check(fp_scene_create(json, (int64_t)strlen(json), &scene));
    check(fp_launch(scene, position, velocity, spin, &kick));
    /* Alternate, and take the least of each: the machine is shared. 100 steps of 10 ms are in the air. */
    for (round = 0; round < ROUNDS; round++) {
        double start = now();
        state = kick;
        for (i = 0; i < STEPS; i++) check(fp_step(scene, &state, 0.01, NULL, 0, NULL));
        start = now() - start;
        if (start < by_call) by_call = start;
        start = now();
        state = kick;
        for (i = 0; i < STEPS; i++) check(fp_step(scene, &state, 0.01, events, 16, &count));
        start = now() - start;
        if (start < with_events) with_events = start;
        start = now();
        state = kick;
        check(fp_step_many(scene, &state, 1, 0.01, STEPS));
        start = now() - start;
        if (start < by_many) by_many = start;
    }
    printf("| C, `fp_step` | %.1f |\n| C, `fp_step` with events | %.1f |\n| C, `fp_step_many`, a ball, 100 steps a call | %.1f |\n", 1e9 * by_call / STEPS, 1e9 * with_events / STEPS, 1e9 * by_many / STEPS);
    return 0;
}
