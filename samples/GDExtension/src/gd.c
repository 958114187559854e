#include "gd.h"

#include <stdlib.h>
#include <string.h>

gd_interface gd;

/* A hash depends on the types of a method's parameters and result. tests/Native/godot-methods.tsv compares these hashes with the public lists of four Godot versions. */
static struct { const char *class_name, *name; int64_t hash; uint32_t since; const void *bind; } methods[GD_BINDS] = {
    { "Object", "emit_signal", 4047867050, 1, NULL },
    { "Node3D", "get_global_transform", 3229777777, 1, NULL },
    { "Node3D", "set_global_transform", 2952846383, 1, NULL },
    { "Node", "set_physics_interpolation_mode", 3202404928, 3, NULL },
    { "Node", "set_process", 2586408642, 1, NULL },
    { "Node", "set_physics_process", 2586408642, 1, NULL },
    { "Node", "get_physics_process_delta_time", 1740695150, 1, NULL },
    { "Engine", "is_editor_hint", 36873697, 1, NULL },
    { "Engine", "get_physics_ticks_per_second", 3905245786, 1, NULL },
    { "Engine", "get_physics_interpolation_fraction", 1740695150, 1, NULL },
};

static void *engine;

int gd_load(gd_get_function get, void *library)
{
    static const int32_t types[] = { GD_BOOL, GD_INT, GD_FLOAT, GD_STRING, GD_VECTOR3, GD_STRING_NAME, GD_OBJECT, GD_PACKED_BYTES, GD_PACKED_VECTOR3 };
    static const int32_t owners[] = { GD_STRING, GD_STRING_NAME, GD_PACKED_BYTES, GD_PACKED_VECTOR3 };
    size_t i;

    memset(&gd, 0, sizeof gd);
    gd.library = library;
#define GD_READ(result, name, arguments) if ((gd.name = (gd_##name)get(#name)) == NULL) return 0;
    GD_INTERFACE(GD_READ)
#undef GD_READ
    gd.editor_help_load_xml_from_utf8_chars_and_len = (void (*)(const char *, int64_t))get("editor_help_load_xml_from_utf8_chars_and_len");
    for (i = 0; i < sizeof types / sizeof types[0]; i++) {
        gd.from[types[i]] = gd.get_variant_from_type_constructor(types[i]);
        gd.to[types[i]] = gd.get_variant_to_type_constructor(types[i]);
    }
    for (i = 0; i < sizeof owners / sizeof owners[0]; i++) gd.destroy[owners[i]] = gd.variant_get_ptr_destructor(owners[i]);
    return 1;
}

int gd_find_methods(void)
{
    gd_version version;
    int i;

    gd.get_godot_version(&version);
    for (i = 0; i < GD_BINDS; i++) {
        gd_name class_name = gd_name_of(methods[i].class_name), name = gd_name_of(methods[i].name);
        int exists = version.major > 4 || version.minor >= methods[i].since;
        methods[i].bind = exists ? gd.classdb_get_method_bind(&class_name, &name, methods[i].hash) : NULL;
        gd_name_free(&class_name);
        gd_name_free(&name);
        if (exists && methods[i].bind == NULL) {
            gd_report(methods[i].name, "This version of Godot has another method of this name. Use an extension that was built for it.");
            return 0;
        }
    }
    return 1;
}

void gd_engine(int method, void *object, const void *argument, void *result)
{
    const void *arguments[1];
    arguments[0] = argument;
    if (object == NULL && engine == NULL) {
        gd_name name = gd_name_of("Engine");
        engine = gd.global_get_singleton(&name);
        gd_name_free(&name);
    }
    if (methods[method].bind != NULL) gd.object_method_bind_ptrcall(methods[method].bind, object != NULL ? object : engine, arguments, result);
}

void gd_emit(void *object, const gd_variant *name, gd_variant *values, int32_t n)
{
    const void *arguments[1 + GD_MOST_ARGUMENTS];
    gd_variant result;
    gd_error error;
    int32_t i;

    arguments[0] = name;
    for (i = 0; i < n; i++) arguments[i + 1] = &values[i];
    gd.object_method_bind_call(methods[GD_EMIT_SIGNAL].bind, object, arguments, n + 1, &result, &error);
    gd.variant_destroy(&result);
    for (i = 0; i < n; i++) gd.variant_destroy(&values[i]);
}

void gd_report(const char *function, const char *message) { gd.print_error_with_message(message, message, function, "football_physics", 0, 0); }

gd_name gd_name_of(const char *text)
{
    gd_name name;
    gd.string_name_new_with_latin1_chars(&name, text, 0);
    return name;
}

void gd_name_free(gd_name *name) { gd.destroy[GD_STRING_NAME](name); }

char *gd_text_of(const gd_string *from)
{
    int64_t bytes = gd.string_to_utf8_chars(from, NULL, 0);
    char *text = malloc((size_t)bytes + 1);
    if (text == NULL) return NULL;
    gd.string_to_utf8_chars(from, text, bytes);
    text[bytes] = '\0';
    return text;
}

void gd_set_text(void *result, const char *text)
{
    gd.destroy[GD_STRING](result);
    gd.string_new_with_utf8_chars(result, text);
}

/* A Variant of either precision. */
typedef union { gd_variant value; uint64_t room[5]; } any_variant;

/* Calls a method of an array in a Variant. Such a call needs no hash, unlike a call of the array's own method. */
static int64_t call_array(gd_variant *array, const char *method, const gd_variant *argument)
{
    gd_name name = gd_name_of(method);
    any_variant result;
    gd_error error;
    const void *arguments[1];
    int64_t value = 0;

    arguments[0] = argument;
    gd.variant_call(array, &name, arguments, argument != NULL, &result.value, &error);
    if (error.error == GD_CALL_OK) gd.to[GD_INT](&value, &result);
    gd.variant_destroy(&result.value);
    gd_name_free(&name);
    return value;
}

int64_t gd_packed_size(int32_t type, const gd_packed *array)
{
    gd_variant variant;
    int64_t size;

    gd.from[type](&variant, (void *)array);
    size = call_array(&variant, "size", NULL);
    gd.variant_destroy(&variant);
    return size;
}

void *gd_set_packed(void *result, int32_t type, int64_t n)
{
    any_variant array, size;
    gd_error error;

    gd.variant_construct(type, &array.value, NULL, 0, &error);
    gd.from[GD_INT](&size, &n);
    call_array(&array.value, "resize", &size.value);
    gd.variant_destroy(&size.value);
    gd.destroy[type](result);
    gd.to[type](result, &array);
    gd.variant_destroy(&array.value);
    if (n == 0) return NULL;
    return type == GD_PACKED_BYTES ? (void *)gd.packed_byte_array_operator_index(result, 0) : (void *)gd.packed_vector3_array_operator_index(result, 0);
}

int gd_check_precision(void)
{
    gd_packed points;
    const char *first, *second;

    gd.variant_get_ptr_constructor(GD_PACKED_VECTOR3, 0)(&points, NULL);
    gd_set_packed(&points, GD_PACKED_VECTOR3, 2);
    first = (const char *)gd.packed_vector3_array_operator_index(&points, 0);
    second = (const char *)gd.packed_vector3_array_operator_index(&points, 1);
    gd.destroy[GD_PACKED_VECTOR3](&points);
    if (second - first == (ptrdiff_t)sizeof(gd_vector3)) return 1;
    gd_report("football_init", "The engine has another precision than the extension. Build the extension with FOOTBALL_GODOT_DOUBLE for an engine with precision=double, and without it for other engines.");
    return 0;
}
