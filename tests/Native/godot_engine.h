/* A stand-in for Godot: the functions of its extension interface that samples/GDExtension calls, as strict as the interface's description says. It counts all values that live.
   It cannot test the editor, the layout of a Variant in a real engine, exports, or hot reload. */
#include "../../samples/GDExtension/src/gd.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };

typedef struct text { int64_t references; char characters[1]; } text;
typedef struct { int64_t references, size, type; unsigned char bytes[1]; } array;
typedef struct { char name[64]; int64_t hash; int requested; } engine_method;
typedef struct { char name[32]; int count, defaults, result, types[GD_MOST_ARGUMENTS]; gd_method_info info; } method;
typedef struct { char name[32]; int count, types[GD_MOST_ARGUMENTS]; } signal;
typedef struct { char name[32], setter[32], getter[32]; } property;
typedef struct { char name[32], parent[32]; gd_class_info info; int methods, signals, properties, constants; method method[MOST]; signal signal[MOST]; property property[MOST]; char constant[MOST][32]; } class_data;
typedef struct { class_data *of; char engine_class[32]; void *instance, *binding; int64_t references; gd_transform3d transform; int counted, interpolation, process, physics; } object;
typedef struct { object *sender; char name[32]; int count; gd_variant values[GD_MOST_ARGUMENTS]; } emission;

static struct { int64_t names, strings, arrays, objects, variants; } live;
static class_data classes[4];
static int class_count, wrong, errors, documents, editor, method_count;
static char last_error[256], documentation[2][16384];
static engine_method engine_methods[MOST];
static int64_t ticks_per_second = 60;
static double interpolation_fraction, physics_delta;
static object engine_object;
static int library_token;
static void (*on_signal)(const emission *happened);

static void expect(int holds, const char *what)
{
    if (holds) return;
    fprintf(stderr, "FAIL  %s\n", what);
    wrong++;
}

/* --- values */

static text *names[512];

static const char *characters(const void *pointer) { return pointer != NULL ? ((const text *)pointer)->characters : ""; }

static text *new_text(const char *from)
{
    text *to = malloc(sizeof *to + strlen(from));
    to->references = 1;
    strcpy(to->characters, from);
    return to;
}

static void name_new(gd_name *to, const char *from, uint8_t is_static)
{
    int i, empty = -1;
    (void)is_static;
    live.names++;
    for (i = 0; i < 512; i++) {
        if (names[i] == NULL) empty = empty < 0 ? i : empty;
        else if (strcmp(names[i]->characters, from) == 0) {
            names[i]->references++;
            to->data = names[i];
            return;
        }
    }
    to->data = names[empty] = new_text(from);
}

static void name_free(void *value)
{
    text *name = ((gd_name *)value)->data;
    int i;
    live.names--;
    if (--name->references > 0) return;
    for (i = 0; i < 512; i++) if (names[i] == name) names[i] = NULL;
    free(name);
}

static void string_new(gd_string *to, const char *from)
{
    to->data = from[0] != '\0' ? new_text(from) : NULL;
    live.strings += to->data != NULL;
}

static void string_free(void *value)
{
    text *string = ((gd_string *)value)->data;
    if (string == NULL) return;
    if (--string->references > 0) return;
    live.strings--;
    free(string);
}

static int64_t string_to_utf8(const gd_string *from, char *to, int64_t capacity)
{
    int64_t bytes = (int64_t)strlen(characters(from->data));
    if (to != NULL) memcpy(to, characters(from->data), (size_t)(bytes < capacity ? bytes : capacity));
    return bytes;
}

static void array_free(void *value)
{
    array *items = ((gd_packed *)value)->data[1];
    if (items == NULL || --items->references > 0) return;
    live.arrays--;
    free(items);
}

/* An array that is written to is not shared. */
static array *array_own(gd_packed *self, int64_t bytes)
{
    array *old = self->data[1], *own;
    if (old != NULL && old->references == 1 && old->size == bytes) return old;
    own = calloc(1, sizeof *own + (size_t)bytes);
    own->references = 1;
    own->size = bytes;
    if (old != NULL) memcpy(own->bytes, old->bytes, (size_t)(old->size < bytes ? old->size : bytes));
    live.arrays++;
    array_free(self);
    return self->data[1] = own;
}

static uint8_t *bytes_at(gd_packed *self, int64_t index) { return array_own(self, ((array *)self->data[1])->size)->bytes + index; }
static const uint8_t *const_bytes_at(const gd_packed *self, int64_t index) { return ((array *)self->data[1])->bytes + index; }
static gd_vector3 *vectors_at(gd_packed *self, int64_t index) { return (gd_vector3 *)bytes_at(self, 0) + index; }

static void reference(object *of, int change)
{
    if (of == NULL || !of->counted || (of->references += change) > 0) return;
    of->of->info.free(of->of->info.userdata, of->instance);
    live.objects--;
    free(of);
}

static void ref_set(void *to, void *value)
{
    object *old = *(object **)to;
    if (old == value) return;
    *(object **)to = value;
    reference(value, 1);
    reference(old, -1);
}

/* A variant: its type in the first word, and its value behind that. */
static void *payload(const gd_variant *of) { return (void *)&of->words[1]; }
static int32_t type_of(const gd_variant *of) { return (int32_t)of->words[0]; }

static const size_t sizes[GD_TYPES] = {
    [GD_BOOL] = 1, [GD_INT] = 8, [GD_FLOAT] = 8, [GD_STRING] = 8, [GD_VECTOR3] = sizeof(gd_vector3), [GD_STRING_NAME] = 8, [GD_OBJECT] = 8, [GD_PACKED_BYTES] = 16, [GD_PACKED_VECTOR3] = 16,
};

/* A copied value holds one more reference. */
static void copied(int32_t type, void *value)
{
    if (type == GD_STRING && *(text **)value != NULL) (*(text **)value)->references++;
    if (type == GD_STRING_NAME) { (*(text **)value)->references++; live.names++; }
    if (type == GD_OBJECT) reference(*(object **)value, 1);
    if ((type == GD_PACKED_BYTES || type == GD_PACKED_VECTOR3) && ((gd_packed *)value)->data[1] != NULL) ((array *)((gd_packed *)value)->data[1])->references++;
}

static void nil_new(gd_variant *to) { memset(to, 0, sizeof *to); live.variants++; }

static void variant_free(gd_variant *value)
{
    int32_t type = type_of(value);
    live.variants--;
    if (type == GD_STRING) string_free(payload(value));
    if (type == GD_STRING_NAME) name_free(payload(value));
    if (type == GD_OBJECT) reference(*(object **)payload(value), -1);
    if (type == GD_PACKED_BYTES || type == GD_PACKED_VECTOR3) array_free(payload(value));
    memset(value, 0xee, sizeof *value);
}

static void variant_of(int32_t type, gd_variant *to, const void *from)
{
    nil_new(to);
    to->words[0] = (uint64_t)type;
    memcpy(payload(to), from, sizes[type]);
    copied(type, payload(to));
}

static void value_of(int32_t type, void *to, const gd_variant *from)
{
    expect(type_of(from) == type, "a variant is read as its own type");
    memcpy(to, payload(from), sizes[type]);
    if (type != GD_OBJECT) copied(type, to);
}

#define CONVERT(type) \
    static void from_##type(void *to, void *from) { variant_of(type, to, from); } \
    static void to_##type(void *to, void *from) { value_of(type, to, from); }
CONVERT(GD_BOOL) CONVERT(GD_INT) CONVERT(GD_FLOAT) CONVERT(GD_STRING) CONVERT(GD_VECTOR3) CONVERT(GD_STRING_NAME) CONVERT(GD_OBJECT) CONVERT(GD_PACKED_BYTES) CONVERT(GD_PACKED_VECTOR3)
#undef CONVERT
#define PAIR(type) [type] = { from_##type, to_##type }
static const struct { gd_convert from, to; } conversions[GD_TYPES] = {
    PAIR(GD_BOOL), PAIR(GD_INT), PAIR(GD_FLOAT), PAIR(GD_STRING), PAIR(GD_VECTOR3), PAIR(GD_STRING_NAME), PAIR(GD_OBJECT), PAIR(GD_PACKED_BYTES), PAIR(GD_PACKED_VECTOR3),
};
#undef PAIR

static gd_convert from_type(int32_t type) { return conversions[type].from; }
static gd_convert to_type(int32_t type) { return conversions[type].to; }
static void construct_empty(void *to, const void *const *args) { (void)args; memset(to, 0, 8); }
static void construct_array(void *to, const void *const *args) { (void)args; memset(to, 0, 16); }
static gd_construct constructor(int32_t type, int32_t index) { (void)index; return type == GD_STRING ? construct_empty : construct_array; }
static gd_destroy destructor(int32_t type) { return type == GD_STRING ? string_free : type == GD_STRING_NAME ? name_free : array_free; }

static void variant_construct(int32_t type, gd_variant *to, const void *const *args, int32_t count, gd_error *error)
{
    gd_packed empty = { { NULL, NULL } };
    (void)args;
    expect((type == GD_PACKED_BYTES || type == GD_PACKED_VECTOR3) && count == 0, "an empty array is constructed");
    variant_of(type, to, &empty);
    error->error = GD_CALL_OK;
}

static void variant_call(gd_variant *self, const gd_name *name, const void *const *args, int64_t count, gd_variant *result, gd_error *error)
{
    gd_packed *items = payload(self);
    int64_t width = type_of(self) == GD_PACKED_BYTES ? 1 : (int64_t)sizeof(gd_vector3), value = 0;

    error->error = GD_CALL_OK;
    expect(type_of(self) == GD_PACKED_BYTES || type_of(self) == GD_PACKED_VECTOR3, "a method of an array is called");
    if (strcmp(characters(name->data), "resize") == 0 && count == 1) array_own(items, width * (int64_t)((const gd_variant *)args[0])->words[1]);
    else if (strcmp(characters(name->data), "size") == 0 && count == 0) value = items->data[1] != NULL ? ((array *)items->data[1])->size / width : 0;
    else expect(0, "an array has the method");
    variant_of(GD_INT, result, &value);
}

/* --- classes */

static class_data *class_named(const char *name)
{
    int i;
    for (i = 0; i < class_count; i++) if (strcmp(classes[i].name, name) == 0) return &classes[i];
    return NULL;
}

static class_data *class_of(const gd_name *name) { return class_named(characters(name->data)); }

static void register_class(void *library, const gd_name *name, const gd_name *parent, const gd_class_info *info)
{
    class_data *to = &classes[class_count++];
    expect(library == &library_token && info->create != NULL && info->free != NULL, "a class has a constructor and a destructor");
    memset(to, 0, sizeof *to);
    strcpy(to->name, characters(name->data));
    strcpy(to->parent, characters(parent->data));
    to->info = *info;
}

static void unregister_class(void *library, const gd_name *name)
{
    (void)library;
    expect(class_of(name) != NULL, "a registered class is unregistered");
    class_of(name)->name[0] = '\0';
}

static void register_method(void *library, const gd_name *of, const gd_method_info *info)
{
    class_data *owner = class_of(of);
    method *to = &owner->method[owner->methods++];
    int i;
    (void)library;
    expect(info->call != NULL && info->ptrcall != NULL, "a method has both calls");
    strcpy(to->name, characters(info->name->data));
    to->count = (int)info->argument_count;
    to->defaults = (int)info->default_count;
    to->result = info->has_return ? info->return_info->type : GD_NIL;
    to->info = *info;
    for (i = 0; i < to->count; i++) {
        to->types[i] = info->arguments[i].type;
        expect(characters(info->arguments[i].name->data)[0] != '\0', "an argument has a name");
    }
    for (i = 0; i < to->defaults; i++) expect(type_of(info->defaults[i]) == to->types[to->count - to->defaults + i], "a default value has the type of its argument");
}

static void register_constant(void *library, const gd_name *of, const gd_name *enumeration, const gd_name *name, int64_t value, uint8_t is_bitfield)
{
    class_data *owner = class_of(of);
    (void)library;
    expect(strcmp(characters(enumeration->data), "Motion") == 0 && value == owner->constants && !is_bitfield, "a constant has its value");
    strcpy(owner->constant[owner->constants++], characters(name->data));
}

static void register_property(void *library, const gd_name *of, const gd_property_info *info, const gd_name *setter, const gd_name *getter)
{
    class_data *owner = class_of(of);
    property *to = &owner->property[owner->properties++];
    int i, found = 0;
    (void)library;
    strcpy(to->name, characters(info->name->data));
    strcpy(to->setter, characters(setter->data));
    strcpy(to->getter, characters(getter->data));
    for (i = 0; i < owner->methods; i++) {
        found += strcmp(owner->method[i].name, to->getter) == 0 && owner->method[i].result == info->type;
        found += strcmp(owner->method[i].name, to->setter) == 0 && owner->method[i].types[0] == info->type;
    }
    expect(found == 1 + (to->setter[0] != '\0'), "a property has registered methods of its type");
}

static void register_signal(void *library, const gd_name *of, const gd_name *name, const gd_property_info *arguments, int64_t count)
{
    class_data *owner = class_of(of);
    signal *to = &owner->signal[owner->signals++];
    int i;
    (void)library;
    strcpy(to->name, characters(name->data));
    to->count = (int)count;
    for (i = 0; i < count; i++) to->types[i] = arguments[i].type;
}

static void *construct_object(const gd_name *name)
{
    object *to = calloc(1, sizeof *to);
    int i;
    strcpy(to->engine_class, characters(name->data));
    to->counted = strcmp(to->engine_class, "Resource") == 0;
    for (i = 0; i < 3; i++) to->transform.rows[i][i] = 1;
    live.objects++;
    return to;
}

static void set_instance(void *of, const gd_name *name, void *instance)
{
    object *to = of;
    to->of = class_of(name);
    to->instance = instance;
    expect(to->of != NULL && strcmp(to->of->parent, to->engine_class) == 0, "an object is of the parent class");
}

static void set_binding(void *of, void *token, void *binding, const gd_binding_callbacks *callbacks)
{
    expect(token == &library_token && callbacks != NULL, "a binding has the library's token");
    ((object *)of)->binding = binding;
}

static void *get_binding(void *of, void *token, const gd_binding_callbacks *callbacks) { return token == &library_token && callbacks == NULL ? ((object *)of)->binding : NULL; }

/* --- the engine's methods */

static const void *find_bind(const gd_name *of, const gd_name *name, int64_t hash)
{
    char full[64];
    int i;
    snprintf(full, sizeof full, "%s.%s", characters(of->data), characters(name->data));
    for (i = 0; i < method_count; i++) {
        if (strcmp(engine_methods[i].name, full) != 0) continue;
        expect(engine_methods[i].hash == hash, "the hash is that of the public list");
        engine_methods[i].requested++;
        return engine_methods[i].hash == hash ? &engine_methods[i] : NULL;
    }
    expect(0, "the method is in godot-methods.tsv");
    return NULL;
}

static void bind_ptrcall(const void *bind, void *of, const void *const *args, void *result)
{
    const char *name = ((const engine_method *)bind)->name;
    object *self = of;
    if (strcmp(name, "Node3D.get_global_transform") == 0) *(gd_transform3d *)result = self->transform;
    else if (strcmp(name, "Node3D.set_global_transform") == 0) self->transform = *(const gd_transform3d *)args[0];
    else if (strcmp(name, "Node.set_physics_interpolation_mode") == 0) self->interpolation = (int)*(const int64_t *)args[0];
    else if (strcmp(name, "Node.set_process") == 0) self->process = *(const uint8_t *)args[0];
    else if (strcmp(name, "Node.set_physics_process") == 0) self->physics = *(const uint8_t *)args[0];
    else if (strcmp(name, "Node.get_physics_process_delta_time") == 0) *(double *)result = physics_delta;
    else {
        expect(self == &engine_object, "a method of Engine is called for its singleton");
        if (strcmp(name, "Engine.is_editor_hint") == 0) *(uint8_t *)result = (uint8_t)editor;
        else if (strcmp(name, "Engine.get_physics_ticks_per_second") == 0) *(int64_t *)result = ticks_per_second;
        else if (strcmp(name, "Engine.get_physics_interpolation_fraction") == 0) *(double *)result = interpolation_fraction;
        else expect(0, name);
    }
}

static void bind_call(const void *bind, void *of, const void *const *args, int64_t count, gd_variant *result, gd_error *error)
{
    object *self = of;
    emission happened;
    const signal *found = NULL;
    int i;

    expect(strcmp(((const engine_method *)bind)->name, "Object.emit_signal") == 0 && type_of(args[0]) == GD_STRING_NAME, "a signal is emitted by its name");
    happened.sender = self;
    happened.count = (int)count - 1;
    strcpy(happened.name, characters(*(void **)payload(args[0])));
    for (i = 0; i < self->of->signals; i++) if (strcmp(self->of->signal[i].name, happened.name) == 0) found = &self->of->signal[i];
    expect(found != NULL && found->count == happened.count, "an emitted signal is registered, with as many values");
    for (i = 0; i < happened.count; i++) {
        happened.values[i] = *(const gd_variant *)args[i + 1];
        expect(found != NULL && found->types[i] == type_of(&happened.values[i]), "an emitted value has its registered type");
    }
    if (on_signal != NULL) on_signal(&happened);
    nil_new(result);
    error->error = GD_CALL_OK;
}

static void version(gd_version *to)
{
    static const gd_version now = { 4, 4, 1, "4.4.1" };
    *to = now;
}

static void print_error(const char *description, const char *message, const char *function, const char *file, int32_t line, uint8_t notify)
{
    (void)description; (void)function; (void)file; (void)line; (void)notify;
    errors++;
    snprintf(last_error, sizeof last_error, "%s", message);
}

static void *singleton(const gd_name *name) { return strcmp(characters(name->data), "Engine") == 0 ? &engine_object : NULL; }
static void load_help(const char *xml, int64_t bytes) { snprintf(documentation[documents++], 16384, "%.*s", (int)bytes, xml); }

static gd_function get_function(const char *name)
{
#define IS(entry, function) if (strcmp(name, entry) == 0) return (gd_function)function;
    IS("get_godot_version", version) IS("print_error_with_message", print_error) IS("string_name_new_with_latin1_chars", name_new) IS("string_new_with_utf8_chars", string_new)
    IS("string_to_utf8_chars", string_to_utf8) IS("variant_new_nil", nil_new) IS("variant_destroy", variant_free) IS("variant_get_type", type_of) IS("variant_construct", variant_construct)
    IS("variant_call", variant_call) IS("get_variant_from_type_constructor", from_type) IS("get_variant_to_type_constructor", to_type) IS("variant_get_ptr_constructor", constructor)
    IS("variant_get_ptr_destructor", destructor) IS("packed_byte_array_operator_index", bytes_at) IS("packed_byte_array_operator_index_const", const_bytes_at)
    IS("packed_vector3_array_operator_index", vectors_at) IS("object_method_bind_call", bind_call) IS("object_method_bind_ptrcall", bind_ptrcall) IS("global_get_singleton", singleton)
    IS("object_get_instance_binding", get_binding) IS("object_set_instance_binding", set_binding) IS("object_set_instance", set_instance) IS("ref_set_object", ref_set)
    IS("classdb_construct_object", construct_object) IS("classdb_get_method_bind", find_bind) IS("classdb_register_extension_class", register_class)
    IS("classdb_register_extension_class_method", register_method) IS("classdb_register_extension_class_integer_constant", register_constant)
    IS("classdb_register_extension_class_property", register_property) IS("classdb_register_extension_class_signal", register_signal)
    IS("classdb_unregister_extension_class", unregister_class) IS("editor_help_load_xml_from_utf8_chars_and_len", load_help)
#undef IS
    return NULL;
}

/* --- what a game does */

static object *instantiate(const char *name)
{
    object *made = class_named(name)->info.create(class_named(name)->info.userdata);
    made->references = made->counted;
    return made;
}

static void release(object *of)
{
    if (of->counted) {
        reference(of, -1);
        return;
    }
    of->of->info.free(of->of->info.userdata, of->instance);
    live.objects--;
    free(of);
}

static void notify(object *of, int32_t what) { of->of->info.notification(of->instance, what); }

/* A physics frame and a frame of drawing, for a node that is processed. */
static void frame_of(object *of, double delta)
{
    physics_delta = delta;
    if (of->physics) notify(of, GD_PHYSICS_PROCESS);
    if (of->process) notify(of, GD_PROCESS);
}

static const method *method_named(const object *of, const char *name)
{
    int i;
    for (i = 0; i < of->of->methods; i++) if (strcmp(of->of->method[i].name, name) == 0) return &of->of->method[i];
    expect(0, name);
    return NULL;
}

/* Calls a method with variants, as a script without types does. It frees the arguments, and returns the error. */
static int call_method(object *of, const char *name, gd_variant *args, int count, gd_variant *result)
{
    const method *called = method_named(of, name);
    const void *pointers[GD_MOST_ARGUMENTS];
    gd_error error = { 0, 0, 0 };
    gd_variant unused;
    int i;

    for (i = 0; i < count; i++) pointers[i] = &args[i];
    if (result == NULL) result = &unused;
    memset(result, 0, sizeof *result);
    called->info.call(called->info.userdata, of->instance, pointers, count, result, &error);
    if (error.error == GD_CALL_OK) expect(type_of(result) == called->result, "a result has its registered type");
    if (type_of(result) == GD_NIL) live.variants++;
    if (result == &unused) variant_free(result);
    for (i = 0; i < count; i++) variant_free(&args[i]);
    return error.error;
}

/* Calls a method with pointers to values, as a script with types does. */
static void call_typed(object *of, const char *name, const void *a, const void *b, const void *c, const void *d, void *result)
{
    const method *called = method_named(of, name);
    const void *pointers[4];
    pointers[0] = a;
    pointers[1] = b;
    pointers[2] = c;
    pointers[3] = d;
    called->info.ptrcall(called->info.userdata, of->instance, pointers, result);
}
