#include "football.h"

#include <math.h>

/* A frame this close to a multiple or a fraction of a step, relative to the frame, counts as it: Godot's delta is rounded. */
#define SAME_LENGTH 1e-6
/* A step is due this early, relative to the step: the sum of frames is rounded. */
#define ALMOST_DUE 1e-3

int64_t steps_in(ball_clock *clock, double frame, double step)
{
    double exact, due;
    if (!(frame > 0)) return 0;
    /* One of both numbers is 1: the frame is a multiple or a fraction of a step. */
    exact = fmax(1.0, rint(frame / step)) * step / fmax(1.0, rint(step / frame));
    clock->frame = fabs(exact - frame) <= SAME_LENGTH * frame ? exact : frame;
    due = floor((clock->left + clock->frame) / step + ALMOST_DUE);
    clock->left += clock->frame - due * step;
    return (int64_t)due;
}
