/* Random calls with random arguments from eight threads that share scenes and matches, free them under one another, and share a ball: nothing may crash, nothing may be written
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
#define MATCHES 12
#define BODIES 4
#define BYTES 4096
#define POINTS 24
#define BALLS 16
#define EVENTS 8
#define ROWS 64
#define GUARD 0xA5

typedef struct { fp_scene *volatile at[SCENES]; fp_match *volatile matches[MATCHES]; } handle_pool;

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
    unsigned char snapshot[FOOTBALL_SNAPSHOT_BYTES];
    unsigned char g5[64];
    fp_ball ball;
    fp_derivatives derivatives;
    unsigned char g6[64];
    char name[16];
    unsigned char g7[64];
    int32_t numbers[BALLS];
    int64_t written;
    unsigned char g8[64];
    fp_match_event happened[EVENTS];
    unsigned char g9[64];
    fp_body bodies[BODIES];
    unsigned char g10[64];
    fp_player players[BODIES];
    fp_interception first;
    fp_window windows[BODIES];
    unsigned char g11[64];
    fp_goal_chance_result chance;
    fp_fit_result fit;
    fp_piece pieces[BODIES];
    fp_fit_match_result match_fit;
    fp_watch watch;
    fp_forces_result forces;
    fp_contact_force contacts[2];
    unsigned char g12[64];
    unsigned char saved[BYTES];
    unsigned char g13[64];
    unsigned char recording[4 * BYTES];
    unsigned char behind[64];
} buffers;

static handle_pool pool;
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

static const char *const match_texts[] = {
    "{}", "{\"bodies\": [{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.2, \"mass\": 3}]}",
    "{\"bodies\": [{\"shape\": \"capsule\", \"from\": [0, 0.2, 0], \"to\": [0, 1.6, 0], \"radius\": 0.25}, {\"shape\": \"box\", \"center\": [0, 1, 0], \"halfSize\": [0.5, 1, 0.2], \"mass\": 75}]}",
    "{\"obstacles\": [{\"shape\": \"sphere\", \"center\": [1, 0.3, -3], \"radius\": 0.3, \"mass\": 4}], \"zones\": [{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 5}]}",
    "{\"bodies\": [{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": -1}]}", "{\"bodies\": 3}",
};

static const char *const chances[] = {
    "{\"position\": [0, 0.11, 0], \"velocity\": [1, 5, -24]}", "{\"position\": [0, 0.11, 0], \"velocity\": [1, 5, -24], \"kicks\": 50, \"alwaysSimulate\": true}",
    "{\"position\": [0, 0.11, 0], \"velocity\": [0, 0, 0], \"goal\": 7}", "{\"velocity\": [0, 5, -20]}",
};

static const char *const fits[] = { "{}", "{\"also\": [\"drag\"]}", "{\"spinDeviation\": 10}", "{\"free\": [\"height\"]}", "{\"also\": 7}", "{\"spinDeviation\": -1}" };

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

/* A match that lives, one that was freed, a scene, or what never was one. */
static fp_match *match(uint64_t *seed)
{
    if (seldom(seed)) return seldom(seed) ? NULL : seldom(seed) ? (fp_match *)pool.at[below(seed, SCENES)] : (fp_match *)(uintptr_t)next(seed);
    return pool.matches[below(seed, MATCHES)];
}

static void keep_match(uint64_t *seed, fp_match *made)
{
    int slot = below(seed, MATCHES);
    fp_match *old = pool.matches[slot];
    pool.matches[slot] = made;
    if (old) fp_match_free(old);
}

static int32_t index_of(uint64_t *seed, int room) { return seldom(seed) ? (int32_t)next(seed) >> below(seed, 32) : below(seed, room); }

static fp_body *bodies(uint64_t *seed, fp_body *into, double time)
{
    int i, k;
    for (i = 0; i < BODIES; i++) {
        vector(seed, into[i].position, 5);
        vector(seed, into[i].velocity, 8);
        vector(seed, into[i].spin, 4);
        for (k = 0; k < 4; k++) into[i].orientation[k] = number(seed, 1);
        into[i].time = seldom(seed) ? number(seed, 10) : time;
        into[i].in_play = seldom(seed) ? index_of(seed, 3) : 1;
    }
    return seldom(seed) ? NULL : into;
}

static fp_player *players(uint64_t *seed, fp_player *into)
{
    int i;
    for (i = 0; i < BODIES; i++) {
        fp_player_default(&into[i]);
        vector(seed, into[i].position, 30);
        vector(seed, into[i].velocity, 5);
        if (seldom(seed)) into[i].reach = number(seed, 2);
        if (seldom(seed)) into[i].acceleration = number(seed, 8);
        if (seldom(seed)) into[i].maximum_height = number(seed, 3);
    }
    return seldom(seed) ? NULL : into;
}

/* A flight as a camera sees it, in rows: the times, then the positions. */
static void track(uint64_t *seed, double *rows)
{
    int i, k;
    for (i = 0; i < POINTS; i++) {
        double t = 0.04 * i, *at = rows + POINTS + 3 * i;
        rows[i] = t;
        at[0] = 3 * t;
        at[1] = 1 + 6 * t - 4.9 * t * t;
        at[2] = -20 * t;
        for (k = 0; k < 3; k++) at[k] += 0.02 * (below(seed, 100) / 50.0 - 1);
    }
    if (seldom(seed)) rows[below(seed, 4 * POINTS)] = number(seed, 50);
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

/* A watch: mostly a right one, now and then none, cancelled, or of another size. */
static fp_watch *watch(uint64_t *seed, fp_watch *own)
{
    own->bytes = seldom(seed) ? (int32_t)next(seed) : (int32_t)sizeof *own;
    own->cancel = below(seed, 4) ? 0 : (int32_t)next(seed);
    own->progress = 0;
    return seldom(seed) ? NULL : own;
}

static fp_status call(uint64_t *seed, buffers *b, int what, fp_state *state)
{
    char json[1024];
    double p[3], v[3], w[3];
    int64_t length;
    int slot = below(seed, SCENES);
    fp_scene *made = NULL;
    fp_match *begun = NULL;
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
        if (seldom(seed)) b->snapshot[below(seed, FOOTBALL_SNAPSHOT_BYTES)] ^= (unsigned char)next(seed);
        return fp_snapshot_read(seldom(seed) ? NULL : b->snapshot, state);
    case 8: case 9: case 10: return fp_launch(scene(seed), vector(seed, p, 50), vector(seed, v, 40), vector(seed, w, 100), state);
    case 11: case 12: return fp_kick(scene(seed), state, vector(seed, v, 40), vector(seed, w, 100));
    case 14: return fp_forces(scene(seed), state, dt(seed), seldom(seed) ? NULL : &b->forces, seldom(seed) ? NULL : b->contacts, (int32_t)count(seed, 2, INT32_MAX), seldom(seed) ? NULL : b->numbers);
    case 13: return fp_read(scene(seed), state, seldom(seed) ? NULL : &b->ball);
    case 15: return fp_read_many(scene(seed), seldom(seed) ? NULL : b->states, count(seed, BALLS, INT64_MAX), b->vectors[0], seldom(seed) ? NULL : b->vectors[1], b->vectors[2], seldom(seed) ? NULL : b->numbers);
    case 16: return fp_step_many(scene(seed), seldom(seed) ? NULL : b->states, count(seed, BALLS, INT64_MAX), dt(seed), (int32_t)count(seed, 20, INT32_MAX));
    case 17: return fp_run_many(scene(seed), b->states, count(seed, 4, INT64_MAX), 0.05 + number(seed, 0.05), number(seed, 10), below(seed, 5) - 1, seldom(seed) ? NULL : b->numbers);
    case 18: return fp_look_ahead(scene(seed), state, number(seed, 5), fabs(number(seed, 0.1)), seldom(seed) ? NULL : b->rows, count(seed, ROWS, INT32_MAX), seldom(seed) ? NULL : &b->written);
    case 21: case 22: case 23: return fp_match_step(match(seed), seldom(seed) ? NULL : b->happened, (int32_t)count(seed, EVENTS, INT32_MAX), seldom(seed) ? NULL : b->numbers);
    case 24: return fp_match_kick(match(seed), index_of(seed, 3), vector(seed, v, 40), vector(seed, w, 100));
    case 25: {
        double q[4] = {number(seed, 1), number(seed, 1), number(seed, 1), number(seed, 1)};
        switch (below(seed, 3)) {
        case 0: return fp_match_place(match(seed), index_of(seed, 3), vector(seed, p, 10));
        case 1: return fp_match_queue_place(match(seed), index_of(seed, 3), vector(seed, p, 10), vector(seed, v, 40), vector(seed, w, 100), seldom(seed) ? NULL : q);
        default: return fp_place(scene(seed), state, vector(seed, p, 50), vector(seed, v, 40), vector(seed, w, 100), seldom(seed) ? NULL : q);
        }
    }
    case 26: case 27:
        if (fp_match_read_balls(match(seed), 0, 1, &b->ball) != FP_OK) b->ball.time = number(seed, 3);
        return fp_match_move_bodies(match(seed), index_of(seed, 2), (int32_t)count(seed, 2, INT32_MAX), bodies(seed, b->bodies, b->ball.time));
    case 28: return fp_match_read_balls(match(seed), index_of(seed, 2), index_of(seed, 2), seldom(seed) ? NULL : &b->ball);
    case 29: return fp_match_read_bodies(match(seed), index_of(seed, 2), index_of(seed, 3), seldom(seed) ? NULL : b->bodies);
    case 30: return fp_match_save(match(seed), seldom(seed) ? NULL : b->saved, count(seed, BYTES, INT32_MAX), seldom(seed) ? NULL : &b->written);
    case 31:
        if (fp_match_save(match(seed), b->saved, BYTES, &b->written) != FP_OK) b->written = below(seed, BYTES);
        if (below(seed, 4) == 0) b->saved[below(seed, BYTES)] ^= (unsigned char)next(seed);
        return fp_match_restore(match(seed), seldom(seed) ? NULL : b->saved, seldom(seed) ? below(seed, BYTES) : b->written);
    case 32: return fp_match_record(match(seed));
    case 33: return fp_match_recording(match(seed), seldom(seed) ? NULL : b->recording, count(seed, 4 * BYTES, INT32_MAX), seldom(seed) ? NULL : &b->written);
    case 34: return below(seed, 2) ? fp_match_seek(match(seed), below(seed, 90) - 10) : fp_match_verify(match(seed), seldom(seed) ? NULL : &b->written);
    case 35: return fp_match_state(match(seed), index_of(seed, 2), scene(seed), state);
    case 36: return fp_match_name(match(seed), index_of(seed, 6), seldom(seed) ? NULL : b->name, (int32_t)count(seed, (int64_t)sizeof b->name, INT32_MAX));
    case 37:
        fp_match_hash(match(seed));
        fp_match_tick(match(seed));
        return FP_OK;
    case 38: return fp_intercept(scene(seed), state, number(seed, 6), players(seed, b->players), (int32_t)count(seed, BODIES, INT32_MAX), seldom(seed) ? NULL : &b->first);
    case 39: return fp_intercept_windows(scene(seed), state, number(seed, 6), players(seed, b->players), (int32_t)count(seed, BODIES, INT32_MAX), seldom(seed) ? NULL : b->windows, (int32_t)count(seed, BODIES, INT32_MAX), seldom(seed) ? NULL : b->numbers);
    case 40:
        if (below(seed, 2)) {
            int32_t sizes[19];
            for (int i = 0; i < 19; i++) sizes[i] = (int32_t)next(seed);
            return fp_check_sizes(FOOTBALL_ABI_VERSION, seldom(seed) ? NULL : sizes, (int32_t)count(seed, 19, INT32_MAX));
        }
        return fp_check_structs(below(seed, 300), below(seed, 300), 96, 72, 72, 96, (int32_t)next(seed), 232, 256, 96, 64, 792, 272, 104);
    case 50:
        if (below(seed, 8) == 0) {
            fp_status recorded = fp_match_recording(match(seed), b->recording, 4 * BYTES, &b->written);
            from = text(seed, match_texts, 4, json, &length);
            status = fp_match_replay(from, length, b->recording, recorded == FP_OK ? b->written : below(seed, BYTES), &begun);
        } else {
            from = text(seed, match_texts, (int)(sizeof match_texts / sizeof match_texts[0]), json, &length);
            status = fp_match_create(from, length, seldom(seed) ? 10001 - below(seed, 3) * 10001 : 1 + below(seed, 3), seldom(seed) ? number(seed, 0.1) : 1.0 / 60, seldom(seed) ? NULL : &begun);
        }
        if (begun) keep_match(seed, begun);
        return status;
    case 51: return fp_match_free(match(seed));
    case 52:
        from = text(seed, chances, (int)(sizeof chances / sizeof chances[0]), json, &length);
        return below(seed, 2) ? fp_goal_chance(scene(seed), from, length, seldom(seed) ? NULL : &b->chance)
            : fp_goal_chance_watched(scene(seed), from, length, seldom(seed) ? NULL : &b->chance, watch(seed, &b->watch));
    case 53:
        track(seed, b->rows);
        from = text(seed, fits, (int)(sizeof fits / sizeof fits[0]), json, &length);
        return below(seed, 2) ? fp_fit(scene(seed), b->rows, seldom(seed) ? NULL : b->rows + POINTS, NULL, count(seed, POINTS, INT32_MAX), from, length, seldom(seed) ? NULL : &b->fit)
            : fp_fit_watched(scene(seed), b->rows, seldom(seed) ? NULL : b->rows + POINTS, NULL, count(seed, POINTS, INT32_MAX), from, length, seldom(seed) ? NULL : &b->fit, watch(seed, &b->watch));
    case 54:
        track(seed, b->rows);
        from = text(seed, fits, (int)(sizeof fits / sizeof fits[0]), json, &length);
        status = fp_fit_match_watched(scene(seed), b->rows, b->rows + POINTS, NULL, count(seed, POINTS, INT32_MAX), from, length, seldom(seed) ? NULL : b->pieces, (int32_t)count(seed, BODIES, INT32_MAX), b->numbers, seldom(seed) ? NULL : &b->match_fit, seldom(seed) ? NULL : &made, watch(seed, &b->watch));
        if (made) fp_scene_free(made);
        return status;
    default: return fp_step(scene(seed), state, dt(seed), seldom(seed) ? NULL : b->events, (int32_t)count(seed, EVENTS, INT32_MAX), seldom(seed) ? NULL : b->numbers);
    }
}

/* A call that takes milliseconds. */
static int rare(uint64_t *seed)
{
    static const int calls_of[] = { 0, 0, 0, 0, 0, 0, 0, 0, 1, 50, 50, 50, 50, 50, 50, 50, 50, 50, 51, 2, 2, 52, 52 };
    int n = (int)(sizeof calls_of / sizeof calls_of[0]);
    return below(seed, 8 * n) == 0 ? 53 + below(seed, 2) : calls_of[below(seed, n)];
}

static void *play(void *argument)
{
    int thread = (int)(intptr_t)argument;
    uint64_t seed = first_seed * 1000 + (uint64_t)thread;
    long i, statuses[8] = { 0 };
    buffers *b = malloc(sizeof *b);
    memset(b, 0, sizeof *b);
    memset(b->before, GUARD, 64); memset(b->g1, GUARD, 64); memset(b->g2, GUARD, 64); memset(b->g3, GUARD, 64); memset(b->g4, GUARD, 64);
    memset(b->g5, GUARD, 64); memset(b->g6, GUARD, 64); memset(b->g7, GUARD, 64); memset(b->g8, GUARD, 64); memset(b->g9, GUARD, 64); memset(b->g10, GUARD, 64);
    memset(b->g11, GUARD, 64); memset(b->g12, GUARD, 64); memset(b->g13, GUARD, 64); memset(b->behind, GUARD, 64);
    for (i = 0; i < calls / THREADS && !failed; i++) {
        /* Few that take milliseconds. */
        int what = below(&seed, 40) ? 3 + below(&seed, 46) : rare(&seed);
        fp_state *own = &b->states[below(&seed, BALLS)], *state = own, before;
        fp_status status;
        if (what == 3 && below(&seed, 4)) what = 19;
        if (seldom(&seed)) state = seldom(&seed) ? NULL : &shared;
        else if (below(&seed, 300) == 0) own->bytes[below(&seed, FOOTBALL_STATE_BYTES)] ^= (unsigned char)next(&seed);
        before = *own;
        status = call(&seed, b, what, state);
        /* The shared ball is written by several threads at once: torn between two of them it may be anything, and is told as FP_INTERNAL at worst. */
        if ((int)status < 0 || (status > (state == &shared ? FP_INTERNAL : FP_ABI) && !(status == FP_CANCELLED && b->watch.cancel))) {
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
        if (!guarded(b->before) || !guarded(b->g1) || !guarded(b->g2) || !guarded(b->g3) || !guarded(b->g4) || !guarded(b->g5) || !guarded(b->g6) || !guarded(b->g7)
            || !guarded(b->g8) || !guarded(b->g9) || !guarded(b->g10) || !guarded(b->g11) || !guarded(b->g12) || !guarded(b->g13) || !guarded(b->behind)) {
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
    for (i = 0; i < MATCHES; i++) {
        fp_match *made;
        const char *json = match_texts[i % 4];
        if (fp_match_create(json, (int64_t)strlen(json), 1 + i % 3, 1.0 / 60, &made) != FP_OK) { printf("%s: %s\n", json, fp_last_error()); return 1; }
        pool.matches[i] = made;
    }
    if (fp_launch(pool.at[0], place, still, still, &shared) != FP_OK) return 1;
    for (i = 0; i < THREADS; i++) if (pthread_create(&threads[i], NULL, play, (void *)(intptr_t)i)) return 1;
    for (i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
    printf(failed ? "failed\n" : "%ld calls from %d threads: no crash, nothing outside a buffer, a sentence for each refusal\n", calls, THREADS);
    return failed;
}
