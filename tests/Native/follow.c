/* Follows a ball through three streams: positions, positions without height, and pixels of two cameras. Every estimate, the path ahead and the saved bytes are in the hashes.
   What it prints must be tests/Native/follow.txt, which a test makes in C# (tests/Golden/Following). */
#include <football_physics.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS 400
#define BLOCK 100
#define INTERVAL 0.02
#define NOISE 0.02
#define ROWS 11

static const double velocities[3][3] = { { 18, 9, 3 }, { -12, 5, 4 }, { 6, 0.5, -14 } };
static const double spins[3][3] = { { 10, 20, -15 }, { 0, 30, 0 }, { -20, 0, 10 } };
static const double cameras[2][12] = {
    { 1500, 0, -960, 38400, 0, -1500, -540, 36600, 0, 0, -1, 40 },
    { -960, 0, -1500, 38400, -540, -1500, 0, 36600, -1, 0, 0, 40 },
};

static double points[POINTS][3];

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

static uint64_t mix_words(uint64_t hash, const void *from, size_t count)
{
    uint64_t word;
    size_t i;
    for (i = 0; i < count; i++) {
        memcpy(&word, (const char *)from + 8 * i, sizeof word);
        hash = mix(hash, word);
    }
    return hash;
}

/* SplitMix64, as a double from 0 to 1. */
static double draw(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
}

static double normal(uint64_t *seed)
{
    double sum = -6;
    int i;
    for (i = 0; i < 12; i++) sum += draw(seed);
    return sum;
}

static void check(fp_status status, const char *what)
{
    if (status != FP_OK) {
        fprintf(stderr, "%s: status %d, %s\n", what, (int)status, fp_last_error());
        exit(1);
    }
}

static void simulate(const fp_scene *scene)
{
    double origin[3] = { 1, 0, 2 }, zero[3] = { 0, 0, 0 };
    uint64_t seed = 7;
    fp_state state;
    fp_ball ball;
    int i, k;
    check(fp_launch(scene, origin, zero, zero, &state), "fp_launch");
    for (i = 0; i < POINTS; i++) {
        int kick = i == 40 ? 0 : i == 170 ? 1 : i == 300 ? 2 : -1;
        if (kick >= 0) check(fp_kick(scene, &state, velocities[kick], spins[kick]), "fp_kick");
        check(fp_read(scene, &state, &ball), "fp_read");
        for (k = 0; k < 3; k++) points[i][k] = ball.position[k] + NOISE * normal(&seed);
        if (i % 37 == 36) points[i][0] += 3;
        check(fp_step(scene, &state, INTERVAL, NULL, 0, NULL), "fp_step");
    }
}

static uint64_t deliver(fp_filter *filter, int kind, int at, uint64_t hash)
{
    const double *p = points[at];
    double time = at * INTERVAL, row[3];
    fp_estimate estimate;
    int i;
    if (kind < 2) {
        row[0] = p[0];
        row[1] = kind == 0 ? p[1] : NAN;
        row[2] = p[2];
        check(fp_filter_update(filter, &time, row, NULL, 1, &estimate), "fp_filter_update");
        return mix_words(hash, &estimate, sizeof estimate / 8);
    }
    for (i = 0; i < 2; i++) {
        const double *m = cameras[i];
        double a = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
        double b = m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7];
        double w = m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11];
        check(fp_filter_update_pixel(filter, time, m, a / w, b / w, 0, &estimate), "fp_filter_update_pixel");
        hash = mix_words(hash, &estimate, sizeof estimate / 8);
    }
    return hash;
}

static uint64_t saved(fp_filter *filter)
{
    int64_t count = 0, i;
    char *bytes;
    uint64_t hash;
    if (fp_filter_save(filter, NULL, 0, &count) != FP_BUFFER) { fprintf(stderr, "fp_filter_save without room is no FP_BUFFER\n"); exit(1); }
    bytes = malloc((size_t)count);
    check(fp_filter_save(filter, bytes, count, &count), "fp_filter_save");
    hash = (uint64_t)count;
    for (i = 0; i < count; i++) hash = mix(hash, (unsigned char)bytes[i]);
    free(bytes);
    return hash;
}

int main(void)
{
    static const char *const kinds[3] = { "position", "plan", "pixel" };
    fp_scene *scene;
    int kind, i;
    check(FOOTBALL_CHECK_ABI(), "FOOTBALL_CHECK_ABI");
    check(fp_scene_create("{}", 2, &scene), "fp_scene_create");
    simulate(scene);
    for (kind = 0; kind < 3; kind++) {
        fp_filter *filter;
        double path[5 * ROWS];
        uint64_t hash = 0;
        int64_t written;
        int held = -1;
        check(fp_filter_create(scene, NULL, &filter), "fp_filter_create");
        for (i = 0; i < POINTS; i++) {
            if (i >= 220 && i < 235) {
                /* Hidden. */
            } else if (i % 29 == 28) {
                held = i;
            } else {
                hash = deliver(filter, kind, i, hash);
                if (held >= 0) hash = deliver(filter, kind, held, hash);
                held = -1;
            }
            if (i % BLOCK == BLOCK - 1) printf("%s %d %016llx\n", kinds[kind], i + 1, (unsigned long long)hash);
        }
        check(fp_filter_look_ahead(filter, (ROWS - 1) * 0.1, 0.1, path, ROWS, &written), "fp_filter_look_ahead");
        printf("%s ahead %016llx\n", kinds[kind], (unsigned long long)mix_words(0, path, (size_t)(5 * written)));
        printf("%s saved %016llx\n", kinds[kind], (unsigned long long)saved(filter));
        check(fp_filter_free(filter), "fp_filter_free");
    }
    check(fp_scene_free(scene), "fp_scene_free");
    return 0;
}
