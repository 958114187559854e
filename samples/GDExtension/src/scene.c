/* FootballScene, a Resource: the text of a scene, compiled once for all balls that use it. */
#include "football.h"

#include <stdlib.h>
#include <string.h>

typedef struct { const gd_class *of; void *object; char *json, *error; fp_scene *compiled; } scene;

static fp_scene *standard;

static char *copy(const char *text)
{
    char *to = malloc(strlen(text) + 1);
    return to != NULL ? strcpy(to, text) : NULL;
}

const fp_scene *default_scene(void)
{
    if (standard == NULL && fp_scene_create("{}", 2, &standard) != FP_OK) gd_report("FootballScene", fp_last_error());
    return standard;
}

void free_default_scene(void)
{
    if (standard != NULL) fp_scene_free(standard);
    standard = NULL;
}

const fp_scene *scene_of(void *object)
{
    scene *self = gd_instance_of(object);
    if (self == NULL || self->of != &scene_class) return NULL;
    return self->compiled != NULL ? self->compiled : default_scene();
}

/* A rejected text is kept, with its error; the balls keep the scene that was compiled before. */
static void set_json(void *instance, const void *const *args, void *result)
{
    scene *self = instance;
    char *json = gd_text_of(args[0]);
    fp_scene *compiled;

    (void)result;
    if (json == NULL) return;
    free(self->json);
    free(self->error);
    self->json = json;
    if (fp_scene_create(json, (int64_t)strlen(json), &compiled) != FP_OK) {
        self->error = copy(fp_last_error());
        gd_report("FootballScene.json", fp_last_error());
        return;
    }
    self->error = NULL;
    if (self->compiled != NULL) fp_scene_free(self->compiled);
    self->compiled = compiled;
}

static void get_json(void *instance, const void *const *args, void *result)
{
    const scene *self = instance;
    (void)args;
    gd_set_text(result, self->json != NULL ? self->json : "{}");
}

static void get_error(void *instance, const void *const *args, void *result)
{
    const scene *self = instance;
    (void)args;
    gd_set_text(result, self->error != NULL ? self->error : "");
}

static void *create(void *userdata)
{
    scene *self = calloc(1, sizeof *self);
    (void)userdata;
    if (self == NULL) return NULL;
    self->of = &scene_class;
    return self->object = gd_create(&scene_class, self);
}

static void destroy(void *userdata, void *instance)
{
    scene *self = instance;
    (void)userdata;
    if (self->compiled != NULL) fp_scene_free(self->compiled);
    free(self->json);
    free(self->error);
    free(self);
}

#define TEXT GD_STRING, NULL, 0, NULL, GD_USAGE_DEFAULT

static const gd_method methods[] = {
    { "set_json", set_json, 0, { 0 }, 1, 0, { { "text", TEXT } } },
    { "get_json", get_json, GD_METHOD_CONST, { "", TEXT }, 0, 0, { { 0 } } },
    { "get_error", get_error, GD_METHOD_CONST, { "", TEXT }, 0, 0, { { 0 } } },
    { 0 },
};

static const gd_property properties[] = {
    { { "json", GD_STRING, NULL, GD_HINT_MULTILINE_TEXT, NULL, GD_USAGE_DEFAULT }, "set_json", "get_json" },
    { { "error", GD_STRING, NULL, 0, NULL, GD_USAGE_NONE }, NULL, "get_error" },
    { { 0 }, NULL, NULL },
};

static const gd_signal signals[] = { { 0 } };
static const gd_constant constants[] = { { 0 } };

const gd_class scene_class = { "FootballScene", "Resource", create, destroy, NULL, methods, properties, signals, constants };
