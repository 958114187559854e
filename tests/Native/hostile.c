/* Random calls with random arguments from eight threads that share scenes, free them under one another, and share a ball: nothing may crash, nothing may be written
   outside a buffer, every call that fails has a sentence, and a refused call leaves the ball as it was.
     hostile [CALLS [SEED]]       default 1 000 000 calls, seed 1 */
#define _POSIX_C_SOURCE 200809L
#include <football_physics.h>
#include <float.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define THREADS 8
#define SCENES 24
#define BALLS 16
#define EVENTS 8
#define ROWS 64
#define GUARD 0xA5

typedef struct { fp_scene *volatile at[SCENES]; } scene_pool;

/* Every buffer that a call may write to, with bytes before and behind it that none may. */
typedef struct {
    unsigned char before[64];
    fp_state states[BALLS];
    unsigned char g1[64];
    fp_event events[EVENTS];
    unsigned char g2[64];
    double rows[4 * ROWS];
    unsigned char g3[64];
    double vectors[4][3 * BALLS];
    unsigned char g4[64];
    unsigned char snapshot[FP_SNAPSHOT_BYTES];
    unsigned char g5[64];
    fp_ball ball;
    fp_derivatives derivatives;
    unsigned char g6[64];
    char name[16];
    unsigned char g7[64];
    int32_t numbers[BALLS];
    int64_t written;
    unsigned char behind[64];
} buffers;

static scene_pool pool;
static fp_state shared;
static long calls = 1000000;
static uint64_t first_seed = 1;
static volatile int failed;

static const char *const texts[] = {
    "{}", "{\"profile\": \"published\"}", "{\"solver\": {\"integrator\": \"rk2\"}}", "{\"air\": {\"wind\": [3, 0, 1]}, \"ground\": {\"surface\": \"wetTurf\"}}",
    "{\"goals\": [{\"center\": [0, 0, -20], \"facing\": [0, 0, 1]}]}",
    "{\"obstacles\": [{\"name\": \"wall\", \"shape\": \"box\", \"center\": [1.5, 0.9, -9.15], \"halfSize\": [1.5, 0.9, 0.2]}], \"gravity\": 3.7}",
    "{\"nets\": [{\"center\": [0, 3, -40], \"normal\": [0, 0, 1], \"along\": [1, 0, 0], \"halfSize\": [10, 3]}]}",
    "{\"ball\": {\"mass\": -1}}", "{\"launch\": 3}", "[[[[[[", "\xff\xfe", "", "null", "{\"gravity\": 1e400}", "{\"air\": {\"density\": 1.2, \"density\": 1.3}}",
    "{\"ground\": {\"heights\": {\"origin\": [-50, -50], \"spacing\": 10, \"values\": [[0,0,1],[0,2,0],[1,0,0]]}}}",
};

static const char *const requests[] = {
    "{\"from\": [0, 0.11, 0], \"target\": [3, 1, -20], \"speed\": 25}", "{\"from\": [0, 0.11, 0], \"target\": [2, 0.11, -15], \"speed\": 20, \"spin\": {\"top\": 10, \"side\": 20}}",
    "{\"from\": [0, 0.11, 0], \"target\": [0, 0.11, 0], \"speed\": 25}", "{\"from\": [0, 0, 0], \"target\": [0, 1, -200], \"speed\": 5}", "{\"target\": [0, 1, -20]}",
    "{\"from\": [0, 0.11, 0], \"target\": [1, 1, -9], \"speed\": 1e9}", "{", "{}",
};

static uint64_t next(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

static int below(uint64_t *seed, int n) { return (int)(next(seed) % (uint64_t)n); }

static int seldom(uint64_t *seed) { return below(seed, 24) == 0; }

/* Mostly a number that a game would give; else one that none would. */
static double number(uint64_t *seed, double size)
{
    static const double odd[] = { NAN, INFINITY, -INFINITY, -0.0, 0.0, DBL_MAX, -DBL_MAX, DBL_MIN, 5e-324, 1e300, 1e-300, 1e6, -1e6, 1000, 10000, 1e12 };
    if (seldom(seed)) return odd[below(seed, (int)(sizeof odd / sizeof odd[0]))];
    return size * (2 * ((double)(next(seed) >> 11) / 9007199254740992.0) - 1);
}

static double *vector(uint64_t *seed, double *into, double size)
{
    int i;
    for (i = 0; i < 3; i++) into[i] = number(seed, size);
    return seldom(seed) ? NULL : into;
}

/* A count that the buffer has room for, or one that no buffer has. */
static int64_t count(uint64_t *seed, int64_t room, int64_t most)
{
    static const int64_t odd[] = { -1, INT64_MIN, INT64_MAX, -4096 };
    if (!seldom(seed)) return (int64_t)below(seed, (int)room + 1);
    return most == INT32_MAX ? -1 - below(seed, 1000) : odd[below(seed, 4)];
}

/* A scene that lives, one that was freed, or what never was one. */
static fp_scene *scene(uint64_t *seed)
{
    if (seldom(seed)) return seldom(seed) ? NULL : (fp_scene *)(uintptr_t)next(seed);
    return pool.at[below(seed, SCENES)];
}

static double dt(uint64_t *seed)
{
    static const double usual[] = { 0, 1e-4, 0.01, 1.0 / 60, 0.1, 1 };
    return seldom(seed) ? number(seed, 1) : usual[below(seed, 6)];
}

static const char *text(uint64_t *seed, const char *const *of, int n, char *room, int64_t *length)
{
    const char *from = of[below(seed, n)];
    int64_t bytes = (int64_t)strlen(from), i;
    memcpy(room, from, (size_t)bytes);
    for (i = below(seed, 4) == 0 ? below(seed, 4) : 0; i > 0 && bytes > 0; i--) room[below(seed, (int)bytes)] = (char)next(seed);
    *length = seldom(seed) ? (below(seed, 2) ? -1 - below(seed, 99) : (int64_t)1 << (21 + below(seed, 40))) : seldom(seed) ? below(seed, (int)bytes + 1) : bytes;
    return seldom(seed) ? NULL : room;
}

static int guarded(const unsigned char *bytes)
{
    int i;
    for (i = 0; i < 64; i++) if (bytes[i] != GUARD) return 0;
    return 1;
}

static fp_status call(uint64_t *seed, buffers *b, int what, fp_state *state)
{
    char json[1024];
    double p[3], v[3], w[3];
    int64_t length;
    int slot = below(seed, SCENES);
    fp_scene *made = NULL;
    fp_status status;
    const char *from;
    switch (what) {
    case 0:
        from = text(seed, texts, (int)(sizeof texts / sizeof texts[0]), json, &length);
        status = fp_scene_create(from, length, seldom(seed) ? NULL : &made);
        if (made) { fp_scene *old = pool.at[slot]; pool.at[slot] = made; if (old) fp_scene_free(old); }
        return status;
    case 1: return fp_scene_free(scene(seed));
    case 2:
        from = text(seed, requests, (int)(sizeof requests / sizeof requests[0]), json, &length);
        return fp_aim(scene(seed), from, length, seldom(seed) ? NULL : b->vectors[0], seldom(seed) ? NULL : b->vectors[1], seldom(seed) ? NULL : b->vectors[2], seldom(seed) ? NULL : b->numbers);
    case 3: return fp_derivatives_run(scene(seed), state, 0.01 + number(seed, 0.01), number(seed, 3), below(seed, 5) - 1, seldom(seed) ? NULL : &b->derivatives, seldom(seed) ? NULL : b->numbers);
    case 4: return fp_check_abi(below(seed, 3), below(seed, 300), (int32_t)next(seed), below(seed, 300));
    case 5: return fp_name(scene(seed), (int32_t)next(seed) >> below(seed, 32), seldom(seed) ? NULL : b->name, (int32_t)count(seed, (int64_t)sizeof b->name, INT32_MAX));
    case 20:
        fp_added_energy(scene(seed), seldom(seed) ? NULL : b->events);
        return FP_OK;
    case 6: return fp_snapshot_write(state, seldom(seed) ? NULL : b->snapshot);
    case 7:
        if (seldom(seed)) b->snapshot[below(seed, FP_SNAPSHOT_BYTES)] ^= (unsigned char)next(seed);
        return fp_snapshot_read(seldom(seed) ? NULL : b->snapshot, state);
    case 8: case 9: case 10: return fp_launch(scene(seed), vector(seed, p, 50), vector(seed, v, 40), vector(seed, w, 100), state);
    case 11: case 12: return fp_kick(scene(seed), state, vector(seed, v, 40), vector(seed, w, 100));
    case 13: case 14: return fp_read(scene(seed), state, seldom(seed) ? NULL : &b->ball);
    case 15: return fp_read_many(scene(seed), seldom(seed) ? NULL : b->states, count(seed, BALLS, INT64_MAX), b->vectors[0], seldom(seed) ? NULL : b->vectors[1], b->vectors[2], seldom(seed) ? NULL : b->numbers);
    case 16: return fp_step_many(scene(seed), seldom(seed) ? NULL : b->states, count(seed, BALLS, INT64_MAX), dt(seed), (int32_t)count(seed, 20, INT32_MAX));
    case 17: return fp_run_many(scene(seed), b->states, count(seed, 4, INT64_MAX), 0.05 + number(seed, 0.05), number(seed, 10), below(seed, 5) - 1, seldom(seed) ? NULL : b->numbers);
    case 18: return fp_look_ahead(scene(seed), state, number(seed, 5), fabs(number(seed, 0.1)), seldom(seed) ? NULL : b->rows, count(seed, ROWS, INT32_MAX), seldom(seed) ? NULL : &b->written);
    default: return fp_step(scene(seed), state, dt(seed), seldom(seed) ? NULL : b->events, (int32_t)count(seed, EVENTS, INT32_MAX), seldom(seed) ? NULL : b->numbers);
    }
}

static void *play(void *argument)
{
    int thread = (int)(intptr_t)argument;
    uint64_t seed = first_seed * 1000 + (uint64_t)thread;
    long i, statuses[8] = { 0 };
    buffers *b = malloc(sizeof *b);
    memset(b, 0, sizeof *b);
    memset(b->before, GUARD, 64); memset(b->g1, GUARD, 64); memset(b->g2, GUARD, 64); memset(b->g3, GUARD, 64); memset(b->g4, GUARD, 64);
    memset(b->g5, GUARD, 64); memset(b->g6, GUARD, 64); memset(b->g7, GUARD, 64); memset(b->behind, GUARD, 64);
    for (i = 0; i < calls / THREADS && !failed; i++) {
        /* Few that take milliseconds. */
        int what = below(&seed, 40) ? 3 + below(&seed, 26) : below(&seed, 12) ? (below(&seed, 6) == 0) : 2;
        fp_state *own = &b->states[below(&seed, BALLS)], *state = own, before;
        fp_status status;
        if (what == 3 && below(&seed, 4)) what = 19;
        if (seldom(&seed)) state = seldom(&seed) ? NULL : &shared;
        else if (below(&seed, 300) == 0) own->bytes[below(&seed, FP_STATE_BYTES)] ^= (unsigned char)next(&seed);
        before = *own;
        status = call(&seed, b, what, state);
        /* The shared ball is written by several threads at once: torn between two of them it may be anything, and is told as FP_INTERNAL at worst. */
        if ((int)status < 0 || status > (state == &shared ? FP_INTERNAL : FP_ABI)) {
            printf("call %ld of thread %d (%d): status %d, %s\n", i, thread, what, (int)status, fp_last_error());
            failed = 1;
        } else if (status != FP_OK && !fp_last_error()[0]) {
            printf("call %ld of thread %d (%d): status %d without a sentence\n", i, thread, what, (int)status);
            failed = 1;
        } else if (status != FP_OK && status != FP_BUFFER && state == own && memcmp(&before, own, sizeof before)) {
            printf("call %ld of thread %d (%d): status %d, and the ball has changed: %s\n", i, thread, what, (int)status, fp_last_error());
            failed = 1;
        }
        statuses[status]++;
        if (!guarded(b->before) || !guarded(b->g1) || !guarded(b->g2) || !guarded(b->g3) || !guarded(b->g4) || !guarded(b->g5) || !guarded(b->g6) || !guarded(b->g7) || !guarded(b->behind)) {
            printf("call %ld of thread %d (%d): written outside a buffer\n", i, thread, what);
            failed = 1;
        }
    }
    printf("thread %d: %ld calls; done %ld, argument %ld, scene %ld, buffer %ld, handle %ld, abi %ld\n", thread, i, statuses[FP_OK], statuses[FP_ARGUMENT], statuses[FP_SCENE],
        statuses[FP_BUFFER], statuses[FP_HANDLE], statuses[FP_ABI]);
    free(b);
    return NULL;
}

int main(int argc, char **argv)
{
    pthread_t threads[THREADS];
    double place[3] = { 0, 1, 0 }, still[3] = { 0, 0, 0 };
    int i;
    if (argc > 1) calls = atol(argv[1]);
    if (argc > 2) first_seed = (uint64_t)atol(argv[2]);
    for (i = 0; i < SCENES; i++) {
        fp_scene *made;
        const char *json = texts[i % 7];
        if (fp_scene_create(json, (int64_t)strlen(json), &made) != FP_OK) { printf("%s: %s\n", json, fp_last_error()); return 1; }
        pool.at[i] = made;
    }
    if (fp_launch(pool.at[0], place, still, still, &shared) != FP_OK) return 1;
    for (i = 0; i < THREADS; i++) if (pthread_create(&threads[i], NULL, play, (void *)(intptr_t)i)) return 1;
    for (i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
    printf(failed ? "failed\n" : "%ld calls from %d threads: no crash, nothing outside a buffer, a sentence for each refusal\n", calls, THREADS);
    return failed;
}
