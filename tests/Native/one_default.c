/* A kick in the default scene, step by step the bits of tests/Golden/one-default.csv, which a test makes in C#.
     one_default TABLE */
#include <football_physics.h>
#include <stdio.h>
#include <string.h>

static int row(FILE *table, double *numbers)
{
    int i;
    for (i = 0; i < 10; i++) {
        if (fscanf(table, i == 0 ? "%lf" : ",%lf", &numbers[i]) != 1) return 0;
    }
    return 1;
}

int main(int argc, char **argv)
{
    fp_scene *scene = NULL;
    fp_state state;
    fp_ball ball;
    int rows = 0;
    double is[10], origin[3] = { 0, 0, 0 };
    FILE *table = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (!table || fscanf(table, "%*[^\n]") != 0 || !row(table, is)) return 2;
    if (fp_scene_create("{}", 2, &scene) != FP_OK || fp_launch(scene, origin, is + 4, is + 7, &state) != FP_OK) return 3;
    do {
        if (rows > 0 && fp_step(scene, &state, 0.01, NULL, 0, NULL) != FP_OK) return 4;
        if (fp_read(scene, &state, &ball) != FP_OK) return 5;
        if (memcmp(ball.position, is + 1, sizeof ball.position) || memcmp(ball.velocity, is + 4, sizeof ball.velocity)
            || memcmp(ball.spin, is + 7, sizeof ball.spin)) {
            fprintf(stderr, "step %d differs\n", rows);
            return 1;
        }
        rows++;
    } while (row(table, is));
    printf("the kick of the default, %d states to rest: the bits of C#\n", rows);
    return ball.motion == FP_MOTION_STOPPED && fp_scene_free(scene) == FP_OK ? 0 : 6;
}
