/* FootballBall, a Node3D: a ball that steps in physics frames, in the time of the game, and is drawn in frames between its last two steps.
   It uses notifications, because a script's own _ready or _physics_process would replace virtual methods of the class. */
#include "football.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_EVENTS = 64, MOST_POINTS = 100000, INTERPOLATION_OFF = 2 };

typedef struct { double time, position[3]; } corner;

typedef struct {
    const gd_class *of;
    void *object;
    gd_variant scene;                       /* holds a reference to the FootballScene, or is nil */
    void *scene_object;
    fp_state state;
    fp_ball before, now;
    corner corners[MOST_EVENTS];            /* the events of the last step, where the path bends */
    int32_t count;
    ball_clock clock;
    double step;
    gd_transform3d start;
    uint8_t placed, ready, failed;
} ball;

/* In the order of fp_event_kind. */
static gd_variant signal_names[10];

static const fp_scene *scene_for(const ball *self)
{
    const fp_scene *own = scene_of(self->scene_object);
    return own != NULL ? own : default_scene();
}

static void read3(const void *argument, double to[3])
{
    const gd_vector3 *from = argument;
    to[0] = from->x;
    to[1] = from->y;
    to[2] = from->z;
}

static gd_vector3 vector_of(const double from[3])
{
    gd_vector3 to;
    to.x = (gd_real)from[0];
    to.y = (gd_real)from[1];
    to.z = (gd_real)from[2];
    return to;
}

/* Reports a call that failed; returns whether it succeeded. */
static uint8_t accepted(fp_status status, const char *function)
{
    if (status != FP_OK) gd_report(function, fp_last_error());
    return status == FP_OK;
}

/* The ball has jumped: nothing lies between its last two steps. */
static void jumped(ball *self)
{
    fp_read(scene_for(self), &self->state, &self->now);
    self->before = self->now;
    self->count = 0;
}

/* Computes the pose at a fraction of the last step. It follows the corners of the path, because a straight line would cut off a bounce. */
static void draw(ball *self, double fraction)
{
    double t0 = self->before.time, t1 = self->now.time, time = t0 + fraction * (t1 - t0), position[3], q[4], rotation[3][3], length = 0, share, sign = 0;
    const double *p0 = self->before.position, *p1 = self->now.position;
    gd_transform3d transform;
    int i, k;

    for (i = 0; i < self->count; i++) {
        if (self->corners[i].time > time) {
            t1 = self->corners[i].time;
            p1 = self->corners[i].position;
            break;
        }
        t0 = self->corners[i].time;
        p0 = self->corners[i].position;
    }
    share = t1 > t0 ? (time - t0) / (t1 - t0) : 1;
    for (k = 0; k < 3; k++) position[k] = p0[k] + share * (p1[k] - p0[k]);
    for (k = 0; k < 4; k++) sign += self->before.orientation[k] * self->now.orientation[k];
    for (k = 0; k < 4; k++) {
        q[k] = (1 - fraction) * self->before.orientation[k] * (sign < 0 ? -1 : 1) + fraction * self->now.orientation[k];
        length += q[k] * q[k];
    }
    for (k = 0; k < 4; k++) q[k] /= sqrt(length);
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, l = (i + 2) % 3;
        rotation[i][i] = 1 - 2 * (q[j] * q[j] + q[l] * q[l]);
        rotation[i][j] = 2 * (q[i] * q[j] - q[l] * q[3]);
        rotation[i][l] = 2 * (q[i] * q[l] + q[j] * q[3]);
    }
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            transform.rows[i][k] = (gd_real)(rotation[i][0] * self->start.rows[0][k] + rotation[i][1] * self->start.rows[1][k] + rotation[i][2] * self->start.rows[2][k]);
    transform.origin = vector_of(position);
    gd_engine(GD_SET_GLOBAL_TRANSFORM, self->object, &transform, NULL);
}

static void emit(ball *self, const fp_scene *scene, const fp_event *event)
{
    gd_vector3 position = vector_of(event->position), before = vector_of(event->velocity_before), velocity = vector_of(event->velocity), spin = vector_of(event->spin);
    double time = event->time;
    gd_variant values[GD_MOST_ARGUMENTS];
    int n = 0, named = event->kind == FP_EVENT_IMPACT || event->kind == FP_EVENT_ENTER_ZONE || event->kind == FP_EVENT_EXIT_ZONE;

    if (event->kind < 0 || event->kind > FP_EVENT_EXIT_ZONE) return;
    gd.from[GD_VECTOR3](&values[n++], &position);
    if (event->kind == FP_EVENT_IMPACT) gd.from[GD_VECTOR3](&values[n++], &before);
    if (event->kind != FP_EVENT_REST) gd.from[GD_VECTOR3](&values[n++], &velocity);
    if (event->kind == FP_EVENT_IMPACT) gd.from[GD_VECTOR3](&values[n++], &spin);
    gd.from[GD_FLOAT](&values[n++], &time);
    if (named) {
        char name[256] = "";
        gd_string text;
        fp_name(scene, event->thing, name, (int32_t)sizeof name);
        gd.string_new_with_utf8_chars(&text, name);
        gd.from[GD_STRING](&values[n++], &text);
        gd.destroy[GD_STRING](&text);
    }
    gd_emit(self->object, &signal_names[event->kind], values, n);
}

static void take_step(ball *self)
{
    fp_event events[MOST_EVENTS];
    int32_t count = 0, i;
    const fp_scene *scene = scene_for(self);
    fp_status status = fp_step(scene, &self->state, self->step, events, MOST_EVENTS, &count);

    if (status != FP_OK && status != FP_BUFFER) {
        if (!self->failed) gd_report("FootballBall", fp_last_error());
        self->failed = 1;
        return;
    }
    self->failed = 0;
    self->before = self->now;
    fp_read(scene, &self->state, &self->now);
    count = count < MOST_EVENTS ? count : MOST_EVENTS;
    self->count = count;
    for (i = 0; i < count; i++) {
        self->corners[i].time = events[i].time;
        memcpy(self->corners[i].position, events[i].position, sizeof events[i].position);
    }
    /* A handler can kick or place the ball, or change its scene. If it frees this scene, the remaining events have empty names. */
    for (i = 0; i < count; i++) emit(self, scene, &events[i]);
}

static int in_editor(void)
{
    uint8_t editor = 0;
    gd_engine(GD_IS_EDITOR, NULL, NULL, &editor);
    return editor;
}

static void begin(ball *self)
{
    int64_t off = INTERPOLATION_OFF, ticks = 60;
    uint8_t yes = 1;

    gd_engine(GD_TICKS_PER_SECOND, NULL, NULL, &ticks);
    gd_engine(GD_SET_INTERPOLATION_MODE, self->object, &off, NULL);
    gd_engine(GD_SET_PROCESS, self->object, &yes, NULL);
    gd_engine(GD_SET_PHYSICS_PROCESS, self->object, &yes, NULL);
    self->step = 1.0 / (double)(ticks > 0 ? ticks : 60);
    gd_engine(GD_GET_GLOBAL_TRANSFORM, self->object, NULL, &self->start);
    self->ready = 1;
    if (!self->placed) {
        double position[3];
        read3(&self->start.origin, position);
        if (accepted(fp_place(scene_for(self), &self->state, position, NULL, NULL, NULL), "FootballBall")) jumped(self);
    }
    draw(self, 1);
}

static void notification(void *instance, int32_t what)
{
    ball *self = instance;
    double delta = 0, since = 0, fraction;
    int64_t due;

    if (what == GD_ENTER_TREE && !self->ready && !in_editor()) begin(self);
    if (!self->ready) return;
    if (what == GD_PHYSICS_PROCESS) {
        gd_engine(GD_PHYSICS_DELTA, self->object, NULL, &delta);
        for (due = steps_in(&self->clock, delta, self->step); due > 0; due--) take_step(self);
    }
    if (what == GD_PROCESS) {
        gd_engine(GD_INTERPOLATION_FRACTION, NULL, NULL, &since);
        fraction = (self->clock.left + since * self->clock.frame) / self->step;
        draw(self, fraction > 1 ? 1 : fraction > 0 ? fraction : 0);
    }
}

static void set_scene(void *instance, const void *const *args, void *result)
{
    ball *self = instance;
    void *object = *(void *const *)args[0];

    (void)result;
    if (object != NULL && scene_of(object) == NULL) {
        gd_report("FootballBall.scene", "scene is not a FootballScene. Assign a FootballScene, or null for the default scene.");
        return;
    }
    gd.variant_destroy(&self->scene);
    self->scene_object = object;
    if (object != NULL) gd.from[GD_OBJECT](&self->scene, &object);
    else gd.variant_new_nil(&self->scene);
}

static void get_scene(void *instance, const void *const *args, void *result)
{
    (void)args;
    gd.ref_set_object(result, ((ball *)instance)->scene_object);
}

static void place(void *instance, const void *const *args, void *result)
{
    ball *self = instance;
    double position[3];

    read3(args[0], position);
    if ((*(uint8_t *)result = accepted(fp_place(scene_for(self), &self->state, position, NULL, NULL, NULL), "FootballBall.place")) == 0) return;
    self->placed = 1;
    jumped(self);
    if (self->ready) draw(self, 1);
}

static uint8_t kick_by(ball *self, const double velocity[3], const double spin[3], const char *function)
{
    if (!accepted(fp_kick(scene_for(self), &self->state, velocity, spin), function)) return 0;
    fp_read(scene_for(self), &self->state, &self->now);
    return 1;
}

static void kick_with(void *instance, const void *const *args, void *result)
{
    double velocity[3], spin[3];
    read3(args[0], velocity);
    read3(args[1], spin);
    *(uint8_t *)result = kick_by(instance, velocity, spin, "FootballBall.kick_with");
}

/* The spin is top (up x d) + side up, where d is the horizontal direction: KickVectors.Spin of the C# library. */
static void kick(void *instance, const void *const *args, void *result)
{
    double speed = *(const double *)args[0], top = *(const double *)args[2], side = *(const double *)args[3], d[3], velocity[3], spin[3], length, flat;
    const char *refusal = NULL;
    int k;

    read3(args[1], d);
    length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    flat = sqrt(d[0] * d[0] + d[2] * d[2]);
    if (!(speed >= 0)) refusal = "speed is negative or not a number; allowed: 0 ... 1000.";
    else if (!(length > 0) || !isfinite(length)) refusal = "direction is zero or not finite; allowed: finite components, not all zero.";
    else if (!(flat > 0) && top != 0) refusal = "direction must not be vertical if top_spin is not 0. Tilt the direction or set top_spin to 0.";
    if (refusal != NULL) {
        gd_report("FootballBall.kick", refusal);
        *(uint8_t *)result = 0;
        return;
    }
    for (k = 0; k < 3; k++) velocity[k] = speed * (d[k] / length);
    spin[0] = flat > 0 ? top * (d[2] / flat) : 0;
    spin[1] = side;
    spin[2] = flat > 0 ? -top * (d[0] / flat) : 0;
    *(uint8_t *)result = kick_by(instance, velocity, spin, "FootballBall.kick");
}

static void get_velocity(void *instance, const void *const *args, void *result)
{
    (void)args;
    *(gd_vector3 *)result = vector_of(((ball *)instance)->now.velocity);
}

static void get_spin(void *instance, const void *const *args, void *result)
{
    (void)args;
    *(gd_vector3 *)result = vector_of(((ball *)instance)->now.spin);
}

static void get_motion(void *instance, const void *const *args, void *result)
{
    (void)args;
    *(int64_t *)result = ((ball *)instance)->now.motion;
}

static void get_time(void *instance, const void *const *args, void *result)
{
    (void)args;
    *(double *)result = ((ball *)instance)->now.time;
}

static void path_ahead(void *instance, const void *const *args, void *result)
{
    ball *self = instance;
    int64_t points = *(const int64_t *)args[0], written = 0, i;
    double *rows;
    gd_vector3 *to;

    if (points < 1 || points > MOST_POINTS || (rows = malloc((size_t)points * 4 * sizeof *rows)) == NULL) {
        char refusal[80];
        snprintf(refusal, sizeof refusal, "points is %" PRId64 "; allowed: 1 ... %d.", points, (int)MOST_POINTS);
        gd_report("FootballBall.path_ahead", refusal);
        gd_set_packed(result, GD_PACKED_VECTOR3, 0);
        return;
    }
    /* Half a step more, so that rounding does not lose the last point. */
    if (fp_look_ahead(scene_for(self), &self->state, ((double)points - 0.5) * self->step, self->step, rows, points, &written) != FP_OK) {
        gd_report("FootballBall.path_ahead", fp_last_error());
        written = 0;
    }
    to = gd_set_packed(result, GD_PACKED_VECTOR3, written);
    for (i = 0; i < written; i++) to[i] = vector_of(rows + 4 * i + 1);
    free(rows);
}

static void save(void *instance, const void *const *args, void *result)
{
    unsigned char *bytes = gd_set_packed(result, GD_PACKED_BYTES, FOOTBALL_SNAPSHOT_BYTES);
    (void)args;
    fp_snapshot_write(&((ball *)instance)->state, bytes);
}

static void restore(void *instance, const void *const *args, void *result)
{
    ball *self = instance;
    const gd_packed *bytes = args[0];
    fp_state state;
    fp_ball read;

    *(uint8_t *)result = 0;
    if (gd_packed_size(GD_PACKED_BYTES, bytes) != FOOTBALL_SNAPSHOT_BYTES) {
        gd_report("FootballBall.restore", "bytes has another length. Pass the bytes of save().");
        return;
    }
    if (!accepted(fp_snapshot_read(gd.packed_byte_array_operator_index_const(bytes, 0), &state), "FootballBall.restore")
        || !accepted(fp_read(scene_for(self), &state, &read), "FootballBall.restore")) return;
    self->state = state;
    self->placed = 1;
    jumped(self);
    if (self->ready) draw(self, 1);
    *(uint8_t *)result = 1;
}

static void hash(void *instance, const void *const *args, void *result)
{
    char text[17];
    (void)args;
    snprintf(text, sizeof text, "%016" PRIx64, fp_hash(&((ball *)instance)->state));
    gd_set_text(result, text);
}

static void *create(void *userdata)
{
    static const double origin[3] = { 0, 0, 0 };
    ball *self = calloc(1, sizeof *self);
    int i;

    (void)userdata;
    if (self == NULL) return NULL;
    self->of = &ball_class;
    self->step = 1.0 / 60;
    for (i = 0; i < 3; i++) self->start.rows[i][i] = 1;
    gd.variant_new_nil(&self->scene);
    accepted(fp_launch(default_scene(), origin, origin, origin, &self->state), "FootballBall");
    jumped(self);
    return self->object = gd_create(&ball_class, self);
}

static void destroy(void *userdata, void *instance)
{
    ball *self = instance;
    (void)userdata;
    gd.variant_destroy(&self->scene);
    free(self);
}

#define OF(type) type, NULL, 0, NULL, GD_USAGE_DEFAULT
#define NOTHING { 0 }
#define ACCEPTED { "", OF(GD_BOOL) }
#define MOTION GD_INT, "FootballBall.Motion", 0, NULL, GD_USAGE_CLASS_IS_ENUM
#define SCENE GD_OBJECT, "FootballScene", GD_HINT_RESOURCE_TYPE, "FootballScene", GD_USAGE_DEFAULT

static const gd_method methods[] = {
    { "set_scene", set_scene, 0, NOTHING, 1, 0, { { "scene", SCENE } } },
    { "get_scene", get_scene, GD_METHOD_CONST, { "", SCENE }, 0, 0, { NOTHING } },
    { "place", place, 0, ACCEPTED, 1, 0, { { "position", OF(GD_VECTOR3) } } },
    { "kick", kick, 0, ACCEPTED, 4, 2, { { "speed", OF(GD_FLOAT) }, { "direction", OF(GD_VECTOR3) }, { "top_spin", OF(GD_FLOAT) }, { "side_spin", OF(GD_FLOAT) } } },
    { "kick_with", kick_with, 0, ACCEPTED, 2, 0, { { "velocity", OF(GD_VECTOR3) }, { "spin", OF(GD_VECTOR3) } } },
    { "get_velocity", get_velocity, GD_METHOD_CONST, { "", OF(GD_VECTOR3) }, 0, 0, { NOTHING } },
    { "get_spin", get_spin, GD_METHOD_CONST, { "", OF(GD_VECTOR3) }, 0, 0, { NOTHING } },
    { "get_motion", get_motion, GD_METHOD_CONST, { "", MOTION }, 0, 0, { NOTHING } },
    { "get_time", get_time, GD_METHOD_CONST, { "", OF(GD_FLOAT) }, 0, 0, { NOTHING } },
    { "path_ahead", path_ahead, GD_METHOD_CONST, { "", OF(GD_PACKED_VECTOR3) }, 1, 0, { { "points", OF(GD_INT) } } },
    { "save", save, GD_METHOD_CONST, { "", OF(GD_PACKED_BYTES) }, 0, 0, { NOTHING } },
    { "restore", restore, 0, ACCEPTED, 1, 0, { { "bytes", OF(GD_PACKED_BYTES) } } },
    { "hash", hash, GD_METHOD_CONST, { "", OF(GD_STRING) }, 0, 0, { NOTHING } },
    { 0 },
};

static const gd_property properties[] = {
    { { "scene", SCENE }, "set_scene", "get_scene" },
    { { "velocity", GD_VECTOR3, NULL, 0, NULL, GD_USAGE_NONE }, NULL, "get_velocity" },
    { { "spin", GD_VECTOR3, NULL, 0, NULL, GD_USAGE_NONE }, NULL, "get_spin" },
    { { "motion", MOTION }, NULL, "get_motion" },
    { { "time", GD_FLOAT, NULL, 0, NULL, GD_USAGE_NONE }, NULL, "get_time" },
    { { 0 }, NULL, NULL },
};

#define POSITION { "position", OF(GD_VECTOR3) }
#define VELOCITY { "velocity", OF(GD_VECTOR3) }
#define TIME { "time", OF(GD_FLOAT) }
#define PLAIN 3, { POSITION, VELOCITY, TIME }
#define ZONE 4, { POSITION, VELOCITY, TIME, { "zone", OF(GD_STRING) } }

/* In the order of fp_event_kind. */
static const gd_signal signals[] = {
    { "impact", 6, { POSITION, { "velocity_before", OF(GD_VECTOR3) }, VELOCITY, { "spin", OF(GD_VECTOR3) }, TIME, { "surface", OF(GD_STRING) } } },
    { "slide", PLAIN }, { "roll", PLAIN }, { "rest", 2, { POSITION, TIME } }, { "net", PLAIN }, { "goal", PLAIN }, { "contact_end", PLAIN }, { "pinned", PLAIN },
    { "enter_zone", ZONE }, { "exit_zone", ZONE }, { 0 },
};

static const gd_constant constants[] = {
    { "Motion", "MOTION_AIRBORNE", FP_MOTION_AIRBORNE }, { "Motion", "MOTION_SLIDING", FP_MOTION_SLIDING }, { "Motion", "MOTION_ROLLING", FP_MOTION_ROLLING },
    { "Motion", "MOTION_STOPPED", FP_MOTION_STOPPED }, { "Motion", "MOTION_PINNED", FP_MOTION_SQUEEZED }, { 0 },
};

const gd_class ball_class = { "FootballBall", "Node3D", create, destroy, notification, methods, properties, signals, constants };

void name_signals(void)
{
    int i;
    for (i = 0; signals[i].name != NULL; i++) {
        gd_name name = gd_name_of(signals[i].name);
        gd.from[GD_STRING_NAME](&signal_names[i], &name);
        gd_name_free(&name);
    }
}

void free_signal_names(void)
{
    int i;
    for (i = 0; signals[i].name != NULL; i++) gd.variant_destroy(&signal_names[i]);
}
