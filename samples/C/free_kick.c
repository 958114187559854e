/* A free kick over a wall: reads a scene from JSON, finds the kick, steps and draws the ball, and prints the events. */
#include <football_physics.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 72, ROWS = 12 };

static void check(fp_status status)
{
    if (status == FP_OK) return;
    fprintf(stderr, "%s\n", fp_last_error());
    exit(1);
}

int main(void)
{
    static const char *const kinds[] = { "impact", "slide", "roll", "rest", "net", "goal", "leave", "squeezed", "enter zone", "exit zone" };
    const char *pitch = "{\"goals\": [{\"center\": [0, 0, -22], \"facing\": [0, 0, 1]}], \"obstacles\": [{\"name\": \"wall\", "
                        "\"shape\": \"box\", \"center\": [1, 0.92, -9.15], \"halfSize\": [1.3, 0.92, 0.2]}]}";
    const char *request = "{\"from\": [0, 0.11, 0], \"target\": [2.9, 1.7, -22], \"speed\": 24, \"spin\": {\"side\": -45, \"top\": 10}}";
    double position[3] = { 0, 0.11, 0 }, velocity[3], spin[3], miss;
    char drawing[ROWS][COLUMNS + 1], name[32];
    int32_t verdict, count, tick, i;
    fp_event events[16];
    fp_scene *scene;
    fp_state state;
    fp_ball ball;

    check(FOOTBALL_CHECK_ABI());
    check(fp_scene_create(pitch, (int64_t)strlen(pitch), &scene));
    check(fp_aim(scene, request, (int64_t)strlen(request), velocity, spin, &miss, &verdict));
    printf("%s: velocity (%.2f, %.2f, %.2f) m/s\n", verdict == FP_AIM_HIT ? "a hit" : "no hit", velocity[0], velocity[1], velocity[2]);
    check(fp_launch(scene, position, velocity, spin, &state));

    /* The drawing from the side, 24 m wide and 3.6 m high, with the wall, and the goal with its bar. */
    memset(drawing, ' ', sizeof drawing);
    for (i = 0; i < 6; i++) drawing[ROWS - 1 - i][(int)(9.15 * 3)] = '#';
    for (i = 0; i < 8; i++) drawing[ROWS - 1 - i][22 * 3] = '|';
    for (tick = 0; tick < 600; tick++) {
        check(fp_read(scene, &state, &ball));
        int column = (int)(-3 * ball.position[2]), row = ROWS - 1 - (int)(ball.position[1] / 0.3);
        if (column >= 0 && column < COLUMNS && row >= 0 && row < ROWS) drawing[row][column] = 'o';
        if (ball.motion == FP_MOTION_STOPPED) break;
        check(fp_step(scene, &state, 1.0 / 60, events, 16, &count));
        for (i = 0; i < count && tick < 120; i++) {
            check(fp_name(scene, events[i].thing, name, sizeof name));
            printf("%5.2f s  %s %s\n", events[i].time, kinds[events[i].kind], name);
        }
    }
    for (i = 0; i < ROWS; i++) printf("%.*s\n", COLUMNS, drawing[i]);
    printf("at rest after %.1f s, hash %016llx\n", ball.time, (unsigned long long)fp_hash(&state));
    return fp_scene_free(scene) != FP_OK;
}
