/* A match of ten minutes: 22 players who run and kick, two keepers who turn, two balls, a substitution, and balls put back into play. Every tick, event and body is in a
   hash a minute. On the way the match is saved and restored, in itself and in a second match, and recorded and replayed.
   What it prints must be tests/Native/match.txt, which a test makes in C#.
     match [MINUTES]       default 10 */
#include <football_physics.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PLAYERS 22
#define BALLS 2
#define MINUTE 3600
#define EVENTS 256
#define STEP (1.0 / 60)

/* Between two ticks of this distance, the match is saved, played on, restored and played again. */
#define SAVES 1499
#define AGAIN 20

#define RECORDED 200
#define FINISHED -2

typedef struct {
    double place[PLAYERS][2];
    int32_t since_kick[BALLS];
    uint64_t seed, hash;
} game;

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

static uint64_t mix_number(uint64_t hash, double number)
{
    uint64_t word;
    memcpy(&word, &number, sizeof word);
    return mix(hash, word);
}

static uint64_t mix_vector(uint64_t hash, const double v[3]) { return mix_number(mix_number(mix_number(hash, v[0]), v[1]), v[2]); }

/* SplitMix64, as a double from -size to size. */
static double draw(game *g, double size)
{
    uint64_t z = (g->seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return size * (2 * ((double)((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0)) - 1);
}

static void check(fp_status status, const char *what)
{
    if (status != FP_OK) {
        fprintf(stderr, "%s: status %d, %s\n", what, (int)status, fp_last_error());
        exit(1);
    }
}

static int is_keeper(int player) { return player % 11 == 0; }

/* The scene: goals, an area, a light obstacle, and the bodies of the players. */
static char *scene(void)
{
    char *json = malloc(8192), *end = json;
    int i;
    end += sprintf(end, "{\"goals\": [{\"center\": [0, 0, -52.5], \"facing\": [0, 0, 1]}, {\"center\": [0, 0, 52.5], \"facing\": [0, 0, -1]}],"
        "\"zones\": [{\"name\": \"area\", \"shape\": \"box\", \"center\": [0, 1, -44], \"halfSize\": [20, 1, 8.5]}],"
        "\"obstacles\": [{\"name\": \"bag\", \"shape\": \"sphere\", \"center\": [3, 0.3, 5], \"radius\": 0.3, \"mass\": 4}], \"bodies\": [");
    for (i = 0; i < PLAYERS; i++) {
        end += sprintf(end, is_keeper(i) ? "%s{\"name\": \"keeper %d\", \"shape\": \"box\", \"center\": [0, 1, 0], \"halfSize\": [0.5, 1, 0.2]}"
            : "%s{\"name\": \"player %d\", \"shape\": \"capsule\", \"from\": [0, 0.25, 0], \"to\": [0, 1.55, 0], \"radius\": 0.25, \"mass\": 75}", i ? ", " : "", i);
    }
    sprintf(end, "]}");
    return json;
}

/* The player of a team who is nearest to a ball. */
static int nearest(const game *g, int team, const double ball[3], double *distance)
{
    int i, found = 11 * team;
    double least = HUGE_VAL;
    for (i = 11 * team; i < 11 * team + 11; i++) {
        double x = ball[0] - g->place[i][0], z = ball[2] - g->place[i][1], d = sqrt(x * x + z * z);
        if (d < least) { least = d; found = i; }
    }
    *distance = least;
    return found;
}

static void move_players(fp_match *match, game *g, const fp_ball *balls, int64_t tick)
{
    fp_body bodies[PLAYERS];
    int chaser[2], i;
    double distance;
    chaser[0] = nearest(g, 0, balls[0].position, &distance);
    chaser[1] = nearest(g, 1, balls[1].position, &distance);
    memset(bodies, 0, sizeof bodies);
    for (i = 0; i < PLAYERS; i++) {
        int team = i / 11, chases = i == chaser[team];
        double x = chases ? balls[team].position[0] : 6.0 * (i % 11) - 30, z = chases ? balls[team].position[2] : (team ? 9.0 : -9.0) * (i % 3 + (is_keeper(i) ? 5.6 : 1));
        double dx = x - g->place[i][0], dz = z - g->place[i][1], d = sqrt(dx * dx + dz * dz), speed = chases ? 7 : 4, c;
        fp_body *b = &bodies[i];
        if (is_keeper(i) && !chases) { dx = balls[0].position[0] * 0.05 - g->place[i][0]; d = sqrt(dx * dx + dz * dz); }
        if (d > speed * STEP) { b->velocity[0] = speed * dx / d; b->velocity[2] = speed * dz / d; }
        b->position[0] = g->place[i][0];
        b->position[2] = g->place[i][1];
        c = d > 0 ? dz / d : 1;
        b->orientation[1] = dx < 0 ? -sqrt((1 - c) / 2) : sqrt((1 - c) / 2);
        b->orientation[3] = sqrt((1 + c) / 2);
        b->spin[1] = is_keeper(i) ? 2 : 0;
        b->time = balls[0].time;
        b->in_play = !(i == 5 && tick / MINUTE % 3 == 1);
        g->place[i][0] += STEP * b->velocity[0];
        g->place[i][1] += STEP * b->velocity[2];
    }
    check(fp_match_move_bodies(match, 0, PLAYERS, bodies), "fp_match_move_bodies");
}

/* Kicks the balls, or puts them back into play; returns whether it did the latter. */
static int kick(fp_match *match, game *g, const fp_ball *balls)
{
    int b, team, placed = 0;
    for (b = 0; b < BALLS; b++) {
        double place[3], velocity[3], spin[3], distance, least = HUGE_VAL;
        const double *at = balls[b].position;
        g->since_kick[b]++;
        for (team = 0; team < 2; team++) {
            nearest(g, team, at, &distance);
            least = distance < least ? distance : least;
        }
        if (fabs(at[0]) > 40 || fabs(at[2]) > 60 || g->since_kick[b] > 1200) {
            place[0] = draw(g, 20);
            place[1] = 1 + draw(g, 1);
            place[2] = draw(g, 30);
            check(fp_match_place(match, b, place), "fp_match_place");
            g->since_kick[b] = 0;
            placed = 1;
        } else if (least < 0.8 && at[1] < 1 && g->since_kick[b] > 30) {
            velocity[0] = draw(g, 18);
            velocity[1] = 4 + draw(g, 4);
            velocity[2] = draw(g, 22);
            spin[0] = draw(g, 40);
            spin[1] = draw(g, 60);
            spin[2] = draw(g, 20);
            check(fp_match_kick(match, b, velocity, spin), "fp_match_kick");
            g->since_kick[b] = 0;
        }
    }
    return placed;
}

static int play(fp_match *match, game *g)
{
    static fp_match_event events[EVENTS];
    fp_ball balls[BALLS];
    fp_body bodies[PLAYERS];
    int32_t count, i;
    int placed;
    check(fp_match_read_balls(match, 0, BALLS, balls), "fp_match_read_balls");
    placed = kick(match, g, balls);
    move_players(match, g, balls, fp_match_tick(match));
    check(fp_match_step(match, events, EVENTS, &count), "fp_match_step");
    for (i = 0; i < count; i++) {
        const fp_match_event *e = &events[i];
        g->hash = mix(g->hash, (uint64_t)(uint32_t)e->event.kind << 32 | (uint32_t)e->event.thing);
        g->hash = mix(g->hash, (uint64_t)(uint32_t)e->ball << 32 | (uint32_t)e->other_ball);
        g->hash = mix(g->hash, (uint32_t)e->body);
        g->hash = mix_number(g->hash, e->event.time);
        g->hash = mix_vector(mix_vector(g->hash, e->event.position), e->event.velocity);
        g->hash = mix_vector(mix_vector(g->hash, e->event.spin), e->event.normal);
        g->hash = mix_number(mix_vector(g->hash, e->impulse), e->added_energy);
    }
    check(fp_match_read_bodies(match, 0, PLAYERS, bodies), "fp_match_read_bodies");
    for (i = 0; i < PLAYERS; i++) g->hash = mix_vector(mix_vector(g->hash, bodies[i].velocity), bodies[i].impulse);
    g->hash = mix(g->hash, fp_match_hash(match));
    return placed;
}

static void same(const game *a, const game *b, const char *what)
{
    if (memcmp(a, b, sizeof *a)) {
        fprintf(stderr, "%s goes another way\n", what);
        exit(1);
    }
}

/* Replays a recording from start to the present of a match. */
static void replay(const char *json, const fp_match *match, int64_t start)
{
    int64_t size = 0, differs;
    unsigned char *recording;
    fp_match *again;
    fp_match_recording(match, NULL, 0, &size);
    recording = malloc((size_t)size);
    check(fp_match_recording(match, recording, size, NULL), "fp_match_recording");
    check(fp_match_replay(json, (int64_t)strlen(json), recording, size, &again), "fp_match_replay");
    check(fp_match_verify(again, &differs), "fp_match_verify");
    check(fp_match_seek(again, start + 70), "fp_match_seek");
    if (differs != -1 || fp_match_tick(again) != start + 70) { fprintf(stderr, "the replay differs at tick %ld\n", (long)differs); exit(1); }
    check(fp_match_seek(again, fp_match_tick(match)), "fp_match_seek");
    if (fp_match_hash(again) != fp_match_hash(match)) { fprintf(stderr, "the replay ends elsewhere\n"); exit(1); }
    check(fp_match_free(again), "fp_match_free");
    free(recording);
}

int main(int argc, char **argv)
{
    char *json = scene();
    int64_t ticks = MINUTE * (argc > 1 ? atol(argv[1]) : 10), tick, size = 0, start = -1;
    unsigned char *saved;
    fp_match *match, *other;
    game g;
    int i;
    memset(&g, 0, sizeof g);
    for (i = 0; i < PLAYERS; i++) g.place[i][0] = 5.0 * (i % 11) - 25;
    for (i = 0; i < PLAYERS; i++) g.place[i][1] = i < 11 ? -10 : 10;
    check(FOOTBALL_CHECK_ABI(), "FOOTBALL_CHECK_ABI");
    check(fp_match_create(json, (int64_t)strlen(json), BALLS, STEP, &match), "fp_match_create");
    check(fp_match_create(json, (int64_t)strlen(json), BALLS, STEP, &other), "fp_match_create");
    if (fp_match_save(match, NULL, 0, &size) != FP_BUFFER) { fprintf(stderr, "fp_match_save without room is no FP_BUFFER\n"); return 1; }
    saved = malloc((size_t)size);
    for (tick = 0; tick < ticks; tick++) {
        if (tick % SAVES == SAVES - 1) {
            game at_save = g, first;
            check(fp_match_save(match, saved, size, NULL), "fp_match_save");
            for (i = 0; i < AGAIN; i++) play(match, &g);
            first = g;
            g = at_save;
            check(fp_match_restore(other, saved, size), "fp_match_restore");
            for (i = 0; i < AGAIN; i++) play(other, &g);
            same(&first, &g, "a match that was restored in another");
            g = at_save;
            check(fp_match_restore(match, saved, size), "fp_match_restore");
        }
        /* A recording ends when a ball is put back into play: the first one of RECORDED ticks is replayed. */
        if (play(match, &g) && start != FINISHED) {
            check(fp_match_record(match), "fp_match_record");
            start = tick + 1;
        }
        if (start >= 0 && tick + 1 - start == RECORDED) {
            replay(json, match, start);
            start = FINISHED;
        }
        if (tick % MINUTE == MINUTE - 1) printf("minute %d %016llx\n", (int)(tick / MINUTE + 1), (unsigned long long)g.hash);
    }
    if (start != FINISHED) { fprintf(stderr, "nothing was replayed\n"); return 1; }
    check(fp_match_free(match), "fp_match_free");
    check(fp_match_free(other), "fp_match_free");
    free(saved);
    free(json);
    return 0;
}
