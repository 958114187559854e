/* Long calls that are cancelled while they run: by another thread, and by a handler of SIGINT. Each would take half a minute or more. */
#include <football_physics.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MATCH_POINTS = 180000, FLIGHT_POINTS = 50000 };

static fp_watch watch;
static double times[MATCH_POINTS], positions[3 * MATCH_POINTS];
static int wrong, checked, by_signal;

static void check(int holds, const char *sentence)
{
    checked++;
    if (holds) return;
    printf("wrong: %s (%s)\n", sentence, fp_last_error());
    wrong = 1;
}

static void on_interrupt(int number)
{
    (void)number;
    *(volatile int32_t *)&watch.cancel = 1;
}

/* Cancels the call of the main thread as soon as it has made progress. */
static void *cancel(void *unused)
{
    while (*(volatile double *)&watch.progress <= 0) usleep(1000);
    if (by_signal) kill(getpid(), SIGINT);
    else *(volatile int32_t *)&watch.cancel = 1;
    return unused;
}

static void begin(pthread_t *thread, int by)
{
    memset(&watch, 0, sizeof watch);
    watch.bytes = (int32_t)sizeof watch;
    by_signal = by;
    if (pthread_create(thread, NULL, cancel, NULL)) exit(1);
}

static void fill(fp_scene *scene, int points, int per_kick, double dt)
{
    double origin[3] = { 0, 0.11, 0 }, velocity[3] = { 3, 8, -22 }, spin[3] = { 0, 40, 0 };
    fp_state ball;
    fp_ball at;
    int i, k;
    for (i = 0; i < points; i++) {
        if (i % per_kick == 0 && fp_launch(scene, origin, velocity, spin, &ball) != FP_OK) exit(1);
        fp_read(scene, &ball, &at);
        times[i] = i * dt;
        for (k = 0; k < 3; k++) positions[3 * i + k] = at.position[k] + 0.01 * ((i * 7 + k * 3) % 5 - 2);
        fp_step(scene, &ball, dt, NULL, 0, NULL);
    }
}

int main(void)
{
    const char *goal = "{\"goals\": [{\"center\": [0, 0, -20], \"facing\": [0, 0, 1]}]}";
    const char *shot = "{\"position\": [0, 0, 0], \"velocity\": [2, 4, -24], \"spread\": {\"azimuthDegrees\": 2}, \"kicks\": 100000000, \"alwaysSimulate\": true}";
    const char *also = "{\"also\": [\"drag\", \"lift\", \"restitution\", \"friction\"]}";
    fp_scene *scene, *fitted;
    fp_fit_result fit;
    fp_fit_match_result match;
    fp_goal_chance_result chance;
    pthread_t thread;
    int by;
    if (FOOTBALL_CHECK_ABI() != FP_OK || fp_scene_create(goal, (int64_t)strlen(goal), &scene) != FP_OK) { puts(fp_last_error()); return 1; }
    signal(SIGINT, on_interrupt);
    for (by = 0; by < 2; by++) {
        fill(scene, MATCH_POINTS, 150, 0.02);
        begin(&thread, by);
        fitted = scene;
        match.rms = -7;
        check(fp_fit_match_watched(scene, times, positions, NULL, MATCH_POINTS, "{}", 2, NULL, 0, NULL, &match, &fitted, &watch) == FP_CANCELLED, "a fit of a match is cancelled");
        pthread_join(thread, NULL);
        check(!fitted && match.rms == -7 && watch.progress > 0 && watch.progress < 0.9, "it wrote nothing but its progress");

        fill(scene, FLIGHT_POINTS, FLIGHT_POINTS, 0.0004);
        begin(&thread, by);
        fit.time = -7;
        check(fp_fit_watched(scene, times, positions, NULL, FLIGHT_POINTS, also, (int64_t)strlen(also), &fit, &watch) == FP_CANCELLED, "a fit of a flight is cancelled");
        pthread_join(thread, NULL);
        check(fit.time == -7 && watch.progress < 0.9, "it wrote nothing but its progress");

        begin(&thread, by);
        chance.scores = -7;
        check(fp_goal_chance_watched(scene, shot, (int64_t)strlen(shot), &chance, &watch) == FP_CANCELLED, "a chance to score is cancelled");
        pthread_join(thread, NULL);
        check(chance.scores == -7 && watch.progress < 0.9, "it wrote nothing but its progress");
    }

    /* A watch that is cancelled before the call, one of another size, and none. */
    check(fp_fit_watched(scene, times, positions, NULL, 200, "{}", 2, &fit, &watch) == FP_CANCELLED, "a call whose watch is cancelled returns at once");
    watch.bytes = 8;
    check(fp_fit_watched(scene, times, positions, NULL, 200, "{}", 2, &fit, &watch) == FP_ARGUMENT, "a watch of another size is rejected");
    check(fp_fit_watched(scene, times, positions, NULL, 200, "{}", 2, &fit, NULL) == FP_OK, "a call needs no watch");
    memset(&watch, 0, sizeof watch);
    watch.bytes = (int32_t)sizeof watch;
    check(fp_fit_watched(scene, times, positions, NULL, 200, "{}", 2, &fit, &watch) == FP_OK && watch.progress == 1, "a call that ends has a progress of 1");
    check(fp_scene_free(scene) == FP_OK, "the scene is still there");
    if (!wrong) printf("cancel.c: %d checks; fits and chances are cancelled by a thread and by SIGINT, and write nothing\n", checked);
    return wrong;
}
