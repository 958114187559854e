/* The two classes of the extension, and the clock of a ball. */
#ifndef FOOTBALL_H
#define FOOTBALL_H

#include "gd.h"
#include <football_physics.h>

extern const gd_class scene_class, ball_class;

/* Returns the compiled scene of a FootballScene; null for another object. */
const fp_scene *scene_of(void *object);
/* Returns the default scene, which is compiled at its first use; null if that failed. */
const fp_scene *default_scene(void);
void free_default_scene(void);
void name_signals(void);
void free_signal_names(void);

/* Counts the steps of a ball in the physics frames, as EngineClock does in C#. */
typedef struct { double left, frame; } ball_clock;
int64_t steps_in(ball_clock *clock, double frame, double step);

#endif
