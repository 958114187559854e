/* What a C program that makes mistakes is told: a status and a sentence for each, and a ball that is as it was. */
#include <football_physics.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int wrong, told;

static void expect(fp_status want, fp_status got, const char *part, const char *what)
{
    told++;
    if (want != got || !strstr(fp_last_error(), part)) {
        printf("%s: status %d, \"%s\"; expected status %d and \"%s\"\n", what, (int)got, fp_last_error(), (int)want, part);
        wrong++;
    }
}

#define EXPECT(status, part, call) expect(status, call, part, #call)

static fp_status create(const char *json, fp_scene **scene) { return fp_scene_create(json, (int64_t)strlen(json), scene); }

static fp_status aim(const fp_scene *scene, const char *json, int32_t *status)
{
    double velocity[3], spin[3];
    return fp_aim(scene, json, (int64_t)strlen(json), velocity, spin, NULL, status);
}

/* An aim at a target, whose reason must begin with a text. */
static void reason(const fp_scene *scene, const char *target, fp_aim_status want, const char *begin)
{
    char json[200];
    int32_t got = -1;
    snprintf(json, sizeof json, "{\"from\": [0,0,0], \"target\": %s, \"speed\": 25}", target);
    told++;
    if (aim(scene, json, &got) != FP_OK || got != want || strncmp(fp_aim_reason(), begin, strlen(begin)) || (want == FP_AIM_HIT) != !fp_aim_reason()[0]) {
        printf("aim at %s: verdict %d, \"%s\"; expected verdict %d and \"%s\"\n", target, (int)got, fp_aim_reason(), (int)want, begin);
        wrong++;
    }
}

int main(void)
{
    double zero[3] = { 0, 0, 0 }, nan[3] = { 0, NAN, 0 }, fast[3] = { 2000, 0, 0 }, kick[3] = { 1, 6, -18 }, path[8], miss;
    int64_t written;
    int32_t count;
    fp_scene *scene, *none;
    fp_state state, before, empty;
    fp_ball ball;
    fp_event event;
    fp_forces_result forces;
    fp_contact_force contact;
    const char *players = "{\"bodies\": [{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.2}]}";
    fp_match *match, *made;
    fp_body body;
    fp_player player;
    fp_interception first;
    fp_goal_chance_result chance;
    fp_fit_result fit;
    unsigned char bytes[64] = { 0 };
    uint64_t hash;
    memset(&empty, 0, sizeof empty);
    if (FOOTBALL_CHECK_ABI() != FP_OK || create("{}", &scene) != FP_OK || fp_launch(scene, zero, kick, zero, &state) != FP_OK) return 2;
    before = state;

    EXPECT(FP_ABI, "allowed: (2, 216, 120, 160)", fp_check_abi(1, 216, 120, 160));
    EXPECT(FP_SCENE, "the input", create("{\"gravity\"", &none));
    EXPECT(FP_SCENE, "gravity is -1; allowed: ", create("{\"gravity\": -1}", &none));
    EXPECT(FP_SCENE, "did you mean gravity", create("{\"gravty\": 9}", &none));
    EXPECT(FP_SCENE, "ground.surface is \"ice\"; allowed: matchTurf", create("{\"ground\": {\"surface\": \"ice\"}}", &none));
    EXPECT(FP_ARGUMENT, "json is null", fp_scene_create(NULL, 0, &none));
    EXPECT(FP_ARGUMENT, "json_bytes is -1", fp_scene_create("{}", -1, &none));
    EXPECT(FP_ARGUMENT, "scene is null", fp_scene_create("{}", 2, NULL));
    EXPECT(FP_HANDLE, "scene is null", fp_step(NULL, &state, 0.01, NULL, 0, NULL));
    EXPECT(FP_HANDLE, "scene is not a valid handle", fp_step((fp_scene *)&state, &state, 0.01, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "state is null", fp_step(scene, NULL, 0.01, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "state was never launched", fp_step(scene, &empty, 0.01, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "dt is NaN", fp_step(scene, &state, NAN, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "dt is -0.01", fp_step(scene, &state, -0.01, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "events is null", fp_step(scene, &state, 0.01, NULL, 4, &count));
    EXPECT(FP_ARGUMENT, "capacity is -4", fp_step(scene, &state, 0.01, &event, -4, &count));
    EXPECT(FP_ARGUMENT, "launch.position is (0, NaN, 0)", fp_launch(scene, nan, kick, zero, &state));
    EXPECT(FP_ARGUMENT, "launch.velocity is (2000, 0, 0)", fp_launch(scene, zero, fast, zero, &state));
    EXPECT(FP_ARGUMENT, "out is null", fp_launch(scene, zero, kick, zero, NULL));
    EXPECT(FP_ARGUMENT, "launch.velocity is (0, NaN, 0)", fp_kick(scene, &state, nan, zero));
    EXPECT(FP_ARGUMENT, "spin is null", fp_kick(scene, &state, kick, NULL));
    EXPECT(FP_ARGUMENT, "out is null", fp_read(scene, &state, NULL));
    EXPECT(FP_ARGUMENT, "out is null", fp_forces(scene, &state, 0.01, NULL, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "dt is 0", fp_forces(scene, &state, 0, &forces, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "contacts is null", fp_forces(scene, &state, 0.01, &forces, NULL, 1, &count));
    EXPECT(FP_ARGUMENT, "capacity is -1", fp_forces(scene, &state, 0.01, &forces, &contact, -1, &count));
    EXPECT(FP_ARGUMENT, "state was never launched", fp_forces(scene, &empty, 0.01, &forces, NULL, 0, NULL));
    EXPECT(FP_ARGUMENT, "n is -1", fp_step_many(scene, &state, -1, 0.01, 1));
    EXPECT(FP_ARGUMENT, "steps is -1", fp_step_many(scene, &state, 1, 0.01, -1));
    EXPECT(FP_ARGUMENT, "states is null", fp_read_many(scene, NULL, 1, path, NULL, NULL, NULL));
    EXPECT(FP_ARGUMENT, "every is 0", fp_look_ahead(scene, &state, 1, 0, path, 2, &written));
    EXPECT(FP_BUFFER, "rows is 2; the look-ahead has 11", fp_look_ahead(scene, &state, 1, 0.1, path, 2, &written));
    EXPECT(FP_SCENE, "target is missing", fp_aim(scene, "{\"from\": [0,0,0], \"speed\": 20}", 30, path, path + 3, &miss, &count));
    EXPECT(FP_ARGUMENT, "velocity is null", fp_aim(scene, "{}", 2, NULL, path, &miss, &count));
    EXPECT(FP_SCENE, "targetVelocity cannot be combined with", aim(scene, "{\"from\": [0,0,0], \"target\": [0,1,-20], \"through\": [0,2,-10], \"targetVelocity\": [1,0,0], \"speed\": 20}", &count));
    reason(scene, "[0,1,-20]", FP_AIM_HIT, "");
    reason(scene, "[0,1,-200]", FP_AIM_OUT_OF_REACH, "Flights at close elevations all pass below the target or fall short of it");
    reason(scene, "[0,60,-10]", FP_AIM_OUT_OF_REACH, "Every allowed kick has too little energy");
    reason(scene, "[0,0,0]", FP_AIM_DEGENERATE, "The direction of the kick is undefined");
    EXPECT(FP_ABI, "allowed: (144, 208, 96, 72, 72, 96, 288, 232, 256, 96, 64, 792, 272, 104)", fp_check_structs(144, 208, 96, 72, 72, 96, 288, 232, 0, 96, 64, 792, 272, 104));
    if (fp_match_create(players, (int64_t)strlen(players), 2, 0.01, &match) != FP_OK || fp_match_read_bodies(match, 0, 1, &body) != FP_OK || fp_player_default(&player) != FP_OK) return 2;
    hash = fp_match_hash(match);
    EXPECT(FP_SCENE, "bodies is unknown", create(players, &none));
    EXPECT(FP_ARGUMENT, "balls is 0", fp_match_create("{}", 2, 0, 0.01, &made));
    EXPECT(FP_ARGUMENT, "dt is 0", fp_match_create("{}", 2, 1, 0, &made));
    EXPECT(FP_HANDLE, "match is null", fp_match_step(NULL, NULL, 0, NULL));
    EXPECT(FP_HANDLE, "match is not a valid handle", fp_match_step((fp_match *)scene, NULL, 0, NULL));
    EXPECT(FP_HANDLE, "scene is not a valid handle", fp_read((fp_scene *)match, &state, &ball));
    EXPECT(FP_ARGUMENT, "ball is 2", fp_match_kick(match, 2, kick, zero));
    EXPECT(FP_ARGUMENT, "kick.velocity is (0, NaN, 0)", fp_match_kick(match, 0, nan, zero));
    EXPECT(FP_ARGUMENT, "launch.position is (0, NaN, 0)", fp_match_place(match, 0, nan));
    EXPECT(FP_ARGUMENT, "place.position is (0, NaN, 0)", fp_match_queue_place(match, 0, nan, NULL, NULL, NULL));
    EXPECT(FP_ARGUMENT, "place.position is (0, NaN, 0)", fp_place(scene, &state, nan, NULL, NULL, NULL));
    EXPECT(FP_ARGUMENT, "n is 2; allowed: 0", fp_match_move_bodies(match, 0, 2, &body));
    body.velocity[0] = 2000;
    EXPECT(FP_ARGUMENT, "bodies[0].velocity is (2000, 0, 0)", fp_match_move_bodies(match, 0, 1, &body));
    EXPECT(FP_ARGUMENT, "events is null", fp_match_step(match, NULL, 3, NULL));
    EXPECT(FP_ARGUMENT, "n is 64", fp_match_restore(match, bytes, 64));
    EXPECT(FP_BUFFER, "capacity is 64; there are", fp_match_save(match, bytes, 64, NULL));
    EXPECT(FP_ARGUMENT, "has no recording", fp_match_recording(match, NULL, 0, &written));
    EXPECT(FP_ARGUMENT, "replays no recording", fp_match_seek(match, 0));
    if (fp_match_hash(match) != hash || fp_match_tick(match) != 0) { printf("a refused call has changed the match\n"); wrong++; }
    player.speed = 0;
    EXPECT(FP_ARGUMENT, "players[0].speed is 0; allowed: above 0", fp_intercept(scene, &state, 5, &player, 1, &first));
    EXPECT(FP_SCENE, "goal is 0; allowed: none", fp_goal_chance(scene, "{\"position\": [0,0,0], \"velocity\": [0,5,-20]}", 44, &chance));
    EXPECT(FP_ARGUMENT, "times is null", fp_fit(scene, NULL, path, NULL, 2, "{}", 2, &fit));
    EXPECT(FP_ARGUMENT, "n is -1", fp_fit_match(scene, path, path, NULL, -1, "{}", 2, NULL, 0, NULL, NULL, NULL));
    if (fp_match_free(match) != FP_OK) wrong++;
    EXPECT(FP_HANDLE, "was freed", fp_match_free(match));
    if (memcmp(&before, &state, sizeof state)) { printf("a refused call has changed the ball\n"); wrong++; }
    if (fp_read(scene, &state, &ball) != FP_OK || fp_scene_free(scene) != FP_OK) wrong++;
    EXPECT(FP_HANDLE, "was freed", fp_scene_free(scene));
    EXPECT(FP_HANDLE, "scene is null", fp_scene_free(NULL));
    printf("refusals: %d of %d have their status and their sentence\n", told - wrong, told);
    return wrong != 0;
}
