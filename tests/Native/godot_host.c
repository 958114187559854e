/* Loads the extension of samples/GDExtension as Godot does, and plays it: the hashes and signals of tests/Native/godot.txt, which C# also computes.
   godot_host EXTENSION godot-methods.tsv */
#include "godot_engine.h"

#include <football_physics.h>
#include <math.h>

static const double frame = 1.0 / 60;
static int seen[16], kick_on_impact, printing;
static double impact_time;
static const char *const signal_order[] = { "impact", "slide", "roll", "rest", "net", "goal", "contact_end", "pinned", "enter_zone", "exit_zone" };

/* The extension calls these functions instead of the library's, because the linker finds the program first: they count the scenes that are not freed. */
static void *extension;
static int scenes;

fp_status fp_scene_create(const char *json, int64_t json_bytes, fp_scene **scene)
{
    fp_status (*create)(const char *, int64_t, fp_scene **), status;
    *(void **)&create = dlsym(extension, "fp_scene_create");
    status = create(json, json_bytes, scene);
    scenes += status == FP_OK;
    return status;
}

fp_status fp_scene_free(fp_scene *scene)
{
    fp_status (*release_scene)(fp_scene *), status;
    *(void **)&release_scene = dlsym(extension, "fp_scene_free");
    status = release_scene(scene);
    expect(status == FP_OK, "a scene is freed once");
    scenes -= status == FP_OK;
    return status;
}

/* --- values */

static gd_variant number(double value) { gd_variant to; variant_of(GD_FLOAT, &to, &value); return to; }
static gd_variant integer(int64_t value) { gd_variant to; variant_of(GD_INT, &to, &value); return to; }
static gd_vector3 vector3(double x, double y, double z) { gd_vector3 to; to.x = (gd_real)x; to.y = (gd_real)y; to.z = (gd_real)z; return to; }
static gd_variant vector(double x, double y, double z) { gd_variant to; gd_vector3 value = vector3(x, y, z); variant_of(GD_VECTOR3, &to, &value); return to; }

static gd_variant string(const char *value)
{
    gd_variant to;
    gd_string of;
    string_new(&of, value);
    variant_of(GD_STRING, &to, &of);
    string_free(&of);
    return to;
}

static gd_variant object_variant(object *value) { gd_variant to; variant_of(GD_OBJECT, &to, &value); return to; }

/* Returns a result that is a text, until the next call. */
static const char *said(object *of, const char *name)
{
    static char text[512];
    gd_variant result;
    expect(call_method(of, name, NULL, 0, &result) == GD_CALL_OK, name);
    snprintf(text, sizeof text, "%s", characters(*(void **)payload(&result)));
    variant_free(&result);
    return text;
}

static int accepts(object *of, const char *name, gd_variant *args, int count)
{
    gd_variant result;
    int accepted;
    expect(call_method(of, name, args, count, &result) == GD_CALL_OK, name);
    accepted = *(uint8_t *)payload(&result);
    variant_free(&result);
    return accepted;
}

static double time_of(object *ball) { double time; call_typed(ball, "get_time", NULL, NULL, NULL, NULL, &time); return time; }
static int64_t motion_of(object *ball) { int64_t motion; call_typed(ball, "get_motion", NULL, NULL, NULL, NULL, &motion); return motion; }
static gd_vector3 position_of(const object *ball) { return ball->transform.origin; }

/* --- scenes of play */

static object *ball_at(gd_vector3 position)
{
    object *ball = instantiate("FootballBall");
    ball->transform.origin = position;
    notify(ball, GD_ENTER_TREE);
    return ball;
}

static int kick_with(object *ball, double vx, double vy, double vz, double sx, double sy, double sz)
{
    gd_variant args[2];
    args[0] = vector(vx, vy, vz);
    args[1] = vector(sx, sy, sz);
    return accepts(ball, "kick_with", args, 2);
}

static void play(object *ball, int frames, double delta)
{
    int i;
    for (i = 0; i < frames; i++) frame_of(ball, delta);
}

static object *scene_with(object *ball, const char *json)
{
    object *scene = instantiate("FootballScene");
    gd_variant text = string(json), held;
    expect(call_method(scene, "set_json", &text, 1, NULL) == GD_CALL_OK, "set_json");
    if (ball != NULL) {
        held = object_variant(scene);
        expect(call_method(ball, "set_scene", &held, 1, NULL) == GD_CALL_OK, "set_scene");
    }
    return scene;
}

static void heard(const emission *happened)
{
    int i;
    for (i = 0; i < 10; i++) seen[i] += strcmp(signal_order[i], happened->name) == 0;
    if (strcmp(happened->name, "impact") != 0) return;
    impact_time = *(double *)payload(&happened->values[4]);
    if (printing) printf("impact on %s after %.3f s\n", characters(*(void **)payload(&happened->values[5])), impact_time);
    /* A handler that kicks the ball while its step reports. */
    if (kick_on_impact > 0 && kick_on_impact--) expect(kick_with(happened->sender, 0, 5, 0, 0, 0, 0), "a handler kicks");
}

/* --- checks */

static void docs_kick(double delta, int frames, int64_t ticks, int64_t ticks_later, const char *what)
{
    object *ball;
    ticks_per_second = ticks;
    ball = ball_at(vector3(0, 0.11, 0));
    ticks_per_second = ticks_later;
    kick_with(ball, 3, 8, -22, 0, 40, 0);
    play(ball, frames, delta);
    printf("%s: %d frames of %.6f s, ball time %.6f s, hash %s\n", what, frames, delta, time_of(ball), said(ball, "hash"));
    release(ball);
    ticks_per_second = 60;
}

static void check_clock(void)
{
    object *ball;
    int i, most = 0, least = 9;
    double delta = (double)0.01f, before = 0, now;

    printing = 1;
    docs_kick(frame, 120, 60, 60, "normal");
    printing = 0;
    docs_kick(frame * 0.3, 400, 60, 60, "time_scale 0.3");
    docs_kick(frame * 8, 15, 60, 60, "time_scale 8");
    docs_kick(frame, 120, 60, 480, "time_scale 8, 480 ticks, set later");
    docs_kick(8.0 / 480, 120, 480, 480, "time_scale 8, 480 ticks, set before");
    docs_kick(1.0 / 240, 480, 60, 240, "240 ticks, set later");

    /* An hour of frames in single precision, which are shorter than the step: each takes one step. */
    ticks_per_second = 100;
    ball = ball_at(vector3(0, 0, 0));
    ticks_per_second = 60;
    for (i = 0; i < 360000; i++) {
        int steps;
        frame_of(ball, delta);
        now = time_of(ball);
        steps = (int)((now - before) / 0.01 + 0.5);
        most = steps > most ? steps : most;
        least = steps < least ? steps : least;
        before = now;
    }
    printf("360000 frames of 1/100 s as a float: %d to %d steps per frame\n", least, most);
    delta = 0;
    frame_of(ball, delta);
    expect(time_of(ball) == before, "a frame without length takes no step");
    release(ball);
}

static void check_kicks(void)
{
    object *ball = ball_at(vector3(0, 0, 0));
    gd_variant args[5];
    gd_vector3 velocity, direction = vector3(0.25, 0.25, -1);
    double speed = 27, top = -10, side = 60;
    uint8_t accepted = 0;
    char before[32];

    args[0] = number(27);
    args[1] = vector(0.25, 0.25, -1);
    args[2] = integer(-10);
    args[3] = integer(60);
    expect(accepts(ball, "kick", args, 4), "a kick is accepted, with an int for a float");
    play(ball, 240, frame);
    printf("kick 27 m/s, top spin -10, side spin 60: hash %s after 240 steps\n", said(ball, "hash"));
    snprintf(before, sizeof before, "%s", said(ball, "hash"));
    release(ball);

    ball = ball_at(vector3(0, 0, 0));
    call_typed(ball, "kick", &speed, &direction, &top, &side, &accepted);
    expect(accepted, "a typed kick is accepted");
    play(ball, 240, frame);
    expect(strcmp(before, said(ball, "hash")) == 0, "both kinds of call give the same bits");
    args[0] = number(20);
    args[1] = vector(0, 1, -1);
    expect(accepts(ball, "kick", args, 2), "a kick needs no spin");
    call_typed(ball, "get_velocity", NULL, NULL, NULL, NULL, &velocity);
    expect(fabs((double)velocity.y - 20 / sqrt(2)) < 1e-5, "the velocity is that of the kick");

    snprintf(before, sizeof before, "%s", said(ball, "hash"));
    errors = 0;
    args[0] = number(20);
    args[1] = vector(0, 1, 0);
    args[2] = number(5);
    expect(!accepts(ball, "kick", args, 3) && errors == 1, "a vertical kick with top spin is rejected");
    args[0] = number(20);
    args[1] = vector(0, 0, 0);
    expect(!accepts(ball, "kick", args, 2) && errors == 2, "a kick without a direction is rejected");
    args[0] = number(2000);
    args[1] = vector(0, 0, 1);
    expect(!accepts(ball, "kick", args, 2) && errors == 3 && strstr(last_error, "velocity") != NULL, "a kick that is too fast is rejected by the library");
    args[0] = number(nan(""));
    args[1] = vector(0, 0, 1);
    expect(!accepts(ball, "kick", args, 2) && errors == 4, "a speed that is not a number is rejected");
    expect(!kick_with(ball, 0, 0, nan(""), 0, 0, 0) && errors == 5, "a velocity that is not a number is rejected");
    args[0] = vector(2e6, 0, 0);
    expect(!accepts(ball, "place", args, 1) && errors == 6, "a position out of range is rejected");
    expect(strcmp(before, said(ball, "hash")) == 0, "a rejected call changes nothing");

    args[0] = number(1);
    expect(call_method(ball, "kick", args, 1, NULL) == GD_CALL_TOO_FEW, "too few arguments");
    args[0] = number(1);
    args[1] = args[2] = args[3] = args[4] = number(1);
    live.variants += 3;
    expect(call_method(ball, "kick", args, 5, NULL) == GD_CALL_TOO_MANY, "too many arguments");
    args[0] = number(1);
    args[1] = string("north");
    expect(call_method(ball, "kick", args, 2, NULL) == GD_CALL_INVALID_ARGUMENT, "an argument of another type");
    release(ball);
}

static void check_saves(void)
{
    object *ball = ball_at(vector3(0, 0, 0));
    gd_variant saved, copy, points, path;
    gd_vector3 ahead[60];
    char end[32], before[32];
    int i, different = 0;
    unsigned char *bytes;

    kick_with(ball, 3, 8, -22, 0, 40, 0);
    play(ball, 60, frame);
    expect(call_method(ball, "save", NULL, 0, &saved) == GD_CALL_OK, "save");
    points = integer(60);
    expect(call_method(ball, "path_ahead", &points, 1, &path) == GD_CALL_OK, "path_ahead");
    expect(((array *)((gd_packed *)payload(&path))->data[1])->size == (int64_t)sizeof ahead, "a path has as many points as steps");
    memcpy(ahead, const_bytes_at(payload(&path), 0), sizeof ahead);
    variant_free(&path);
    for (i = 0; i < 60; i++) {
        interpolation_fraction = 1;
        notify(ball, GD_PROCESS);
        different += memcmp(&ahead[i], &ball->transform.origin, sizeof ahead[i]) != 0;
        play(ball, 1, frame);
    }
    interpolation_fraction = 0;
    expect(different == 0, "the ball follows its predicted path");
    snprintf(end, sizeof end, "%s", said(ball, "hash"));
    copy = saved;
    copied(GD_PACKED_BYTES, payload(&copy));
    live.variants++;
    expect(accepts(ball, "restore", &copy, 1), "restore");
    play(ball, 60, frame);
    printf("saved at 60, restored: hash %s after 120 steps, %s\n", said(ball, "hash"), strcmp(end, said(ball, "hash")) == 0 ? "as before" : "DIFFERENT");

    errors = 0;
    snprintf(before, sizeof before, "%s", said(ball, "hash"));
    copy = saved;
    copied(GD_PACKED_BYTES, payload(&copy));
    live.variants++;
    bytes = bytes_at(payload(&copy), 0);
    bytes[40] ^= 1;
    expect(!accepts(ball, "restore", &copy, 1) && errors == 1, "corrupt bytes are rejected");
    array_own(payload(&saved), 10);
    expect(!accepts(ball, "restore", &saved, 1) && errors == 2, "bytes of another length are rejected");
    expect(strcmp(before, said(ball, "hash")) == 0, "rejected bytes change nothing");
    points = integer(0);
    expect(call_method(ball, "path_ahead", &points, 1, &path) == GD_CALL_OK && errors == 3, "a path without points is rejected");
    variant_free(&path);
    release(ball);
}

static void check_scenes(void)
{
    object *ball = ball_at(vector3(0, 0, 0)), *other = ball_at(vector3(0, 0, 0)), *scene, *shelf, *returned = NULL;
    gd_variant held, text;
    int i;

    memset(seen, 0, sizeof seen);
    scene = scene_with(ball, "{\"goals\": [{\"center\": [0, 0, -22], \"facing\": [0, 0, 1]}], \"zones\": [{\"name\": \"area\", \"shape\": \"box\", \"center\": [0, 2, -14], \"halfSize\": [9, 3, 2]}]}");
    expect(said(scene, "get_error")[0] == '\0', last_error);
    held = object_variant(scene);
    expect(call_method(other, "set_scene", &held, 1, NULL) == GD_CALL_OK, "a second ball shares the scene");
    kick_with(ball, 0, 4, -24, 0, 0, 0);
    play(ball, 900, frame);
    expect(motion_of(ball) == FP_MOTION_STOPPED, "the ball comes to rest");
    printf("a shot into the goal: impact %d, net %d, goal %d, enter_zone %d, exit_zone %d, rest %d, hash %s\n", seen[0], seen[4], seen[5], seen[8], seen[9], seen[3], said(ball, "hash"));

    call_typed(ball, "get_scene", NULL, NULL, NULL, NULL, &returned);
    expect(returned == scene && scene->references == 4, "a scene is held by its user, two balls and a result");
    ref_set(&returned, NULL);
    expect(call_method(ball, "get_scene", NULL, 0, &held) == GD_CALL_OK && scene->references == 4, "a result in a variant holds a reference");
    variant_free(&held);
    text = string("{\"gravity\": -1}");
    errors = 0;
    call_method(scene, "set_json", &text, 1, NULL);
    expect(errors == 1 && strstr(said(scene, "get_error"), "gravity") != NULL, "a rejected scene reports its error");
    expect(strcmp(said(scene, "get_json"), "{\"gravity\": -1}") == 0, "a rejected text stays");
    expect(kick_with(ball, 0, 3, 5, 0, 0, 0), "the ball keeps its last scene");
    play(ball, 60, frame);
    text = string("{}");
    call_method(scene, "set_json", &text, 1, NULL);
    expect(errors == 1 && said(scene, "get_error")[0] == '\0', "a valid text replaces a rejected one");
    play(ball, 60, frame);
    expect(errors == 1, "the scene changes during play");
    held = object_variant(other);
    errors = 0;
    call_method(ball, "set_scene", &held, 1, NULL);
    expect(errors == 1 && scene->references == 3, "another object is not a scene");
    release(scene);
    expect(scene->references == 2, "the balls keep the scene");

    /* A ball that rolls over the edge of a shelf leaves its surface. */
    shelf = scene_with(other, "{\"obstacles\": [{\"name\": \"shelf\", \"shape\": \"box\", \"center\": [0, 0.5, 0], \"halfSize\": [1, 0.5, 1]}]}");
    memset(seen, 0, sizeof seen);
    held = vector(0, 1.125, 0);
    expect(accepts(other, "place", &held, 1), "place");
    play(other, 30, frame);
    kick_with(other, 2, 0, 0, 0, 0, 0);
    play(other, 900, frame);
    printf("over the edge of a shelf: impact %d, slide %d, roll %d, contact_end %d, rest %d\n", seen[0], seen[1], seen[2], seen[6], seen[3]);
    release(shelf);

    /* A kick out of a handler. */
    kick_on_impact = 3;
    memset(seen, 0, sizeof seen);
    held = vector(5, 1, 5);
    accepts(other, "place", &held, 1);
    play(other, 600, frame);
    expect(kick_on_impact == 0 && seen[0] > 3, "a handler kicks the ball");
    memset(&held, 0, sizeof held);
    live.variants++;
    expect(call_method(other, "set_scene", &held, 1, NULL) == GD_CALL_OK, "null is the default scene");
    for (i = 0; i < 2; i++) release(i == 0 ? ball : other);
}

static void check_drawing(void)
{
    object *ball = instantiate("FootballBall");
    gd_vector3 here, there;
    gd_variant place;
    double half = frame / 2;
    int i, k;

    /* A node that is scaled by 2 keeps its scale, and turns with the ball. */
    for (i = 0; i < 3; i++) ball->transform.rows[i][i] = 2;
    ball->transform.origin = vector3(1, 2, 3);
    notify(ball, GD_ENTER_TREE);
    expect(fabs((double)position_of(ball).y - 2) < 1e-6 && ball->interpolation == 2, "a ball starts at its node, without Godot's own interpolation");
    kick_with(ball, 10, 0, 0, 0, 0, 31.4159265358979);
    frame_of(ball, frame);
    here = position_of(ball);
    interpolation_fraction = 0.5;
    notify(ball, GD_PROCESS);
    there = position_of(ball);
    expect(fabs((double)here.x - 1) < 1e-6 && fabs((double)there.x - 1 - 5 * frame) < 1e-3, "the ball is drawn between its last two steps");
    expect(fabs((double)ball->transform.rows[1][0] - 2 * sin(31.4159265358979 * half)) < 1e-3 && fabs((double)ball->transform.rows[0][0] - 2 * cos(31.4159265358979 * half)) < 1e-3, "the node turns with the ball");
    for (i = 0; i < 3; i++) {
        double length = 0;
        for (k = 0; k < 3; k++) length += (double)ball->transform.rows[k][i] * (double)ball->transform.rows[k][i];
        expect(fabs(sqrt(length) - 2) < 1e-5, "the node keeps its scale");
    }
    interpolation_fraction = 0;
    release(ball);

    /* A ball that bounces within a step is drawn down to the ground. */
    ball = ball_at(vector3(0, 3, 0));
    memset(seen, 0, sizeof seen);
    while (seen[0] == 0) frame_of(ball, frame);
    interpolation_fraction = 1 - (time_of(ball) - impact_time) / frame;
    notify(ball, GD_PROCESS);
    expect(fabs((double)position_of(ball).y - 0.11) < 1e-3, "the drawn path follows a bounce");
    interpolation_fraction = 0;
    release(ball);

    editor = 1;
    ball = ball_at(vector3(0, 5, 0));
    play(ball, 60, frame);
    expect(position_of(ball).y == 5 && time_of(ball) == 0 && !ball->process && !ball->physics, "a ball in the editor stands still");
    release(ball);
    editor = 0;

    /* A script of the ball kicks it before it is in the tree. A ball that enters the tree again continues. */
    ball = instantiate("FootballBall");
    place = vector(1, 3, 0);
    accepts(ball, "place", &place, 1);
    kick_with(ball, 0, 5, 0, 0, 0, 0);
    notify(ball, GD_ENTER_TREE);
    play(ball, 30, frame);
    here = position_of(ball);
    notify(ball, GD_ENTER_TREE);
    expect(here.x == 1 && here.y > 3 && memcmp(&here, &ball->transform.origin, sizeof here) == 0, "a ball that was placed and kicked before stays so");
    release(ball);
}

/* Each class is documented: as many entries as the class has, each with its name. */
static void check_documentation(void)
{
    int i, k, at = 0;
    for (i = 0; i < class_count; i++) {
        const class_data *of = &classes[i];
        const char *xml = documentation[i], *found;
        char entry[128];
        int entries = 0, expected = of->signals + of->properties + of->constants;

        snprintf(entry, sizeof entry, "<class name=\"%.31s\" inherits=\"%.31s\"", of->name, of->parent);
        expect(strstr(xml, entry) != NULL, entry);
        for (k = 0; k < of->methods; k++) {
            if (strncmp(of->method[k].name, "get_", 4) == 0 || strncmp(of->method[k].name, "set_", 4) == 0) continue;
            snprintf(entry, sizeof entry, "<method name=\"%s\"", of->method[k].name);
            expect(strstr(xml, entry) != NULL, entry);
            expected++;
        }
        for (k = 0; k < of->signals + of->properties + of->constants; k++) {
            int signals = of->signals, properties = of->properties;
            if (k < signals) snprintf(entry, sizeof entry, "<signal name=\"%s\"", of->signal[k].name);
            else if (k < signals + properties) snprintf(entry, sizeof entry, "<member name=\"%s\"", of->property[k - signals].name);
            else snprintf(entry, sizeof entry, "<constant name=\"%s\" value=\"%d\"", of->constant[k - signals - properties], k - signals - properties);
            expect(strstr(xml, entry) != NULL, entry);
        }
        for (found = xml; (found = strchr(found, '<')) != NULL; found++)
            entries += strncmp(found, "<method ", 8) == 0 || strncmp(found, "<signal ", 8) == 0 || strncmp(found, "<member ", 8) == 0 || strncmp(found, "<constant ", 10) == 0;
        expect(entries == expected, "the documentation has no other entries");
        at += entries;
        printf("%s: %d methods, %d properties, %d signals, %d constants\n", of->name, of->methods, of->properties, of->signals, of->constants);
    }
    expect(at > 0 && documents == class_count, "each class is documented");
}

static void read_methods(const char *path)
{
    char line[1024], of[16], name[40];
    long long hash[4];
    FILE *file = fopen(path, "r");

    expect(file != NULL, path);
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#' || strncmp(line, "class\t", 6) == 0) continue;
        expect(sscanf(line, "%15s %39s %lld %lld %lld %lld", of, name, &hash[0], &hash[1], &hash[2], &hash[3]) == 6, line);
        expect(hash[0] == hash[1] && hash[1] == hash[2] && hash[2] == hash[3], "a hash is the same in four versions");
        snprintf(engine_methods[method_count].name, sizeof engine_methods[0].name, "%s.%s", of, name);
        engine_methods[method_count++].hash = hash[0];
    }
    if (file != NULL) fclose(file);
}

int main(int count, char **arguments)
{
    gd_initialization initialization;
    uint8_t (*init)(gd_get_function, void *, gd_initialization *);
    int level, i, created;

    if (count != 3) return 2;
    read_methods(arguments[2]);
    extension = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
    if (extension == NULL) { fprintf(stderr, "%s\n", dlerror()); return 1; }
    *(void **)&init = dlsym(extension, "football_init");
    if (init == NULL || !init(get_function, &library_token, &initialization)) { fprintf(stderr, "football_init: %s\n", last_error); return 1; }
    on_signal = heard;
    for (level = 0; level <= GD_LEVEL_EDITOR; level++) if (level >= initialization.minimum_level) initialization.initialize(initialization.userdata, level);
    if (class_count == 0) { printf("%s\n", last_error); return 3; }
    expect(class_count == 2, "two classes are registered");

    check_documentation();
    check_clock();
    check_kicks();
    check_saves();
    check_scenes();
    check_drawing();

    created = scenes;
    for (level = GD_LEVEL_EDITOR; level >= initialization.minimum_level; level--) initialization.deinitialize(initialization.userdata, level);
    for (i = 0; i < method_count; i++) expect(engine_methods[i].requested == 1, "each method of the table is used");
    printf("left: %d names, %d strings, %d arrays, %d objects, %d variants, %d scenes\n", (int)live.names, (int)live.strings, (int)live.arrays, (int)live.objects, (int)live.variants, scenes);
    expect(created == 1, "at the end, only the default scene is left");
    return wrong != 0;
}
