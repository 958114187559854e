/* 10 000 kicks to rest in three scenes, every tick and every event of them in a hash a hundred kicks; saved and restored on the way.
   What it prints must be tests/Native/kicks.txt, which a test makes in C#.
     kicks [COUNT]       so many in each scene; default all */
#include <football_physics.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BLOCK 100
#define TICKS 1200
#define EVENTS 64

static const struct { const char *name, *json; int kicks; } scenes[] = {
    { "default", "{}", 3400 },
    { "published", "{\"profile\": \"published\"}", 3300 },
    { "pitch", "{\"goals\": [{\"center\": [0, 0, -52.5], \"facing\": [0, 0, 1]}, {\"center\": [0, 0, 52.5], \"facing\": [0, 0, -1]}]}", 3300 },
};

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

/* SplitMix64, as a double from 0 to 1. */
static double draw(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
}

static void check(fp_status status, const char *what)
{
    if (status != FP_OK) {
        fprintf(stderr, "%s: status %d, %s\n", what, (int)status, fp_last_error());
        exit(1);
    }
}

static uint64_t tick(const fp_scene *scene, fp_state *state, uint64_t hash)
{
    fp_event events[EVENTS];
    int32_t count, i;
    size_t word;
    check(fp_step(scene, state, 1.0 / 60, events, EVENTS, &count), "fp_step");
    for (i = 0; i < count; i++) {
        uint64_t words[sizeof(fp_event) / 8];
        memcpy(words, &events[i], sizeof words);
        words[0] = (uint64_t)(uint32_t)events[i].kind << 32 | (uint32_t)events[i].thing;
        for (word = 0; word < sizeof words / 8; word++) hash = mix(hash, words[word]);
    }
    return mix(hash, fp_hash(state));
}

static uint64_t kick(const fp_scene *scene, uint64_t seed, uint64_t hash)
{
    double position[3], velocity[3], spin[3];
    fp_state state, saved;
    fp_ball ball;
    uint64_t at_save = 0, at_restore = 0;
    int i;
    position[0] = 60 * draw(&seed) - 30;
    position[1] = 2 * draw(&seed);
    position[2] = 90 * draw(&seed) - 45;
    for (i = 0; i < 3; i++) velocity[i] = 50 * draw(&seed) - 25;
    for (i = 0; i < 3; i++) spin[i] = 120 * draw(&seed) - 60;
    check(fp_launch(scene, position, velocity, spin, &state), "fp_launch");
    saved = state;
    for (i = 0; i < TICKS; i++) {
        hash = tick(scene, &state, hash);
        check(fp_read(scene, &state, &ball), "fp_read");
        if (ball.motion == FP_MOTION_STOPPED) break;
        if (i == 29) { saved = state; at_save = hash; }
        if (i == 59) {
            /* The second half of a second again, from what was saved. */
            fp_state again = saved;
            at_restore = at_save;
            for (; i > 29; i--) at_restore = tick(scene, &again, at_restore);
            i = 59;
            if (at_restore != hash || memcmp(&again, &state, sizeof state)) {
                fprintf(stderr, "a restored ball goes another way\n");
                exit(1);
            }
        }
    }
    return hash;
}

int main(int argc, char **argv)
{
    size_t s;
    check(FOOTBALL_CHECK_ABI(), "fp_check_abi");
    for (s = 0; s < sizeof scenes / sizeof scenes[0]; s++) {
        fp_scene *scene;
        uint64_t hash = 0;
        int i, kicks = argc > 1 ? atoi(argv[1]) : scenes[s].kicks;
        check(fp_scene_create(scenes[s].json, (int64_t)strlen(scenes[s].json), &scene), scenes[s].json);
        for (i = 0; i < kicks; i++) {
            hash = kick(scene, (uint64_t)i, hash);
            if (i % BLOCK == BLOCK - 1) printf("%s %d %016llx\n", scenes[s].name, i + 1, (unsigned long long)hash);
        }
        check(fp_scene_free(scene), "fp_scene_free");
    }
    return 0;
}
