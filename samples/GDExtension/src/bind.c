/* Registers classes from tables, and converts the values of calls. Godot calls a method with Variants, or directly with pointers to values. */
#include "gd.h"

#include <string.h>

typedef struct { gd_name name, class_name; gd_string hint; } parts;

static gd_property_info open_info(const gd_field *field, parts *owned)
{
    gd_property_info info;
    owned->name = gd_name_of(field->name != NULL ? field->name : "");
    owned->class_name = gd_name_of(field->class_name != NULL ? field->class_name : "");
    gd.string_new_with_utf8_chars(&owned->hint, field->hint_string != NULL ? field->hint_string : "");
    info.type = field->type;
    info.name = &owned->name;
    info.class_name = &owned->class_name;
    info.hint = field->hint;
    info.hint_string = &owned->hint;
    info.usage = field->usage;
    return info;
}

static void close_info(parts *owned)
{
    gd_name_free(&owned->name);
    gd_name_free(&owned->class_name);
    gd.destroy[GD_STRING](&owned->hint);
}

/* Reads an argument. GDScript passes an int for a float, and null for an object. */
static int read_value(const gd_variant *from, int32_t type, gd_value *to)
{
    int32_t actual = gd.variant_get_type(from);
    memset(to, 0, sizeof *to);
    if (actual == GD_NIL && type == GD_OBJECT) return 1;
    if (actual == GD_INT && type == GD_FLOAT) {
        gd.to[GD_INT](to, (void *)from);
        to->number = (double)to->integer;
        return 1;
    }
    if (actual != type) return 0;
    gd.to[type](to, (void *)from);
    return 1;
}

static void free_value(int32_t type, gd_value *value)
{
    if (gd.destroy[type] != NULL) gd.destroy[type](value);
}

static void call(void *userdata, void *self, const void *const *args, int64_t count, void *result, gd_error *error)
{
    const gd_method *method = userdata;
    gd_value values[GD_MOST_ARGUMENTS], returned;
    const void *pointers[GD_MOST_ARGUMENTS];
    int32_t i, read = 0, type = method->result.type;

    error->error = count > method->count ? GD_CALL_TOO_MANY : count < method->count - method->defaults ? GD_CALL_TOO_FEW : GD_CALL_OK;
    error->expected = error->error == GD_CALL_TOO_FEW ? method->count - method->defaults : method->count;
    for (i = 0; i < method->count && error->error == GD_CALL_OK; i++) {
        pointers[i] = &values[i];
        if (i >= count) memset(&values[i], 0, sizeof values[i]);
        else if (!read_value(args[i], method->arguments[i].type, &values[i])) {
            error->error = GD_CALL_INVALID_ARGUMENT;
            error->argument = i;
            error->expected = method->arguments[i].type;
            break;
        }
        read++;
    }
    if (error->error == GD_CALL_OK) {
        memset(&returned, 0, sizeof returned);
        if (gd.destroy[type] != NULL) gd.variant_get_ptr_constructor(type, 0)(&returned, NULL);
        method->call(self, pointers, &returned);
        if (type != GD_NIL) gd.from[type](result, &returned);
        free_value(type, &returned);
        /* An object is returned as a reference. */
        if (type == GD_OBJECT) gd.ref_set_object(&returned.object, NULL);
    }
    for (i = 0; i < read && i < count; i++) free_value(method->arguments[i].type, &values[i]);
}

static void ptrcall(void *userdata, void *self, const void *const *args, void *result) { ((const gd_method *)userdata)->call(self, args, result); }

static void add_method(const gd_name *of, const gd_method *method)
{
    gd_property_info result, arguments[GD_MOST_ARGUMENTS];
    parts result_parts, argument_parts[GD_MOST_ARGUMENTS];
    int32_t metadata[GD_MOST_ARGUMENTS] = { 0 }, i;
    gd_variant zero;
    void *defaults[GD_MOST_ARGUMENTS];
    double none = 0;
    gd_name name = gd_name_of(method->name);
    gd_method_info info;

    memset(&info, 0, sizeof info);
    gd.from[GD_FLOAT](&zero, &none);
    result = open_info(&method->result, &result_parts);
    for (i = 0; i < method->count; i++) {
        arguments[i] = open_info(&method->arguments[i], &argument_parts[i]);
        defaults[i] = &zero;
    }
    info.name = &name;
    info.userdata = (void *)method;
    info.call = call;
    info.ptrcall = ptrcall;
    info.flags = GD_METHOD_NORMAL | method->flags;
    info.has_return = method->result.type != GD_NIL;
    info.return_info = &result;
    info.argument_count = (uint32_t)method->count;
    info.arguments = arguments;
    info.argument_metadata = metadata;
    info.default_count = (uint32_t)method->defaults;
    info.defaults = defaults;
    gd.classdb_register_extension_class_method(gd.library, of, &info);
    close_info(&result_parts);
    for (i = 0; i < method->count; i++) close_info(&argument_parts[i]);
    gd.variant_destroy(&zero);
    gd_name_free(&name);
}

static void add_property(const gd_name *of, const gd_property *property)
{
    parts owned;
    gd_property_info info = open_info(&property->field, &owned);
    gd_name setter = gd_name_of(property->setter != NULL ? property->setter : ""), getter = gd_name_of(property->getter);

    gd.classdb_register_extension_class_property(gd.library, of, &info, &setter, &getter);
    gd_name_free(&setter);
    gd_name_free(&getter);
    close_info(&owned);
}

static void add_signal(const gd_name *of, const gd_signal *signal)
{
    gd_property_info arguments[GD_MOST_ARGUMENTS];
    parts owned[GD_MOST_ARGUMENTS];
    gd_name name = gd_name_of(signal->name);
    int32_t i;

    for (i = 0; i < signal->count; i++) arguments[i] = open_info(&signal->arguments[i], &owned[i]);
    gd.classdb_register_extension_class_signal(gd.library, of, &name, arguments, signal->count);
    for (i = 0; i < signal->count; i++) close_info(&owned[i]);
    gd_name_free(&name);
}

static void add_constant(const gd_name *of, const gd_constant *constant)
{
    gd_name enumeration = gd_name_of(constant->enumeration), name = gd_name_of(constant->name);

    gd.classdb_register_extension_class_integer_constant(gd.library, of, &enumeration, &name, constant->value, 0);
    gd_name_free(&enumeration);
    gd_name_free(&name);
}

void gd_register(const gd_class *of)
{
    gd_name name = gd_name_of(of->name), parent = gd_name_of(of->parent);
    gd_class_info info;

    memset(&info, 0, sizeof info);
    info.create = of->create;
    info.free = of->free;
    info.notification = of->notification;
    gd.classdb_register_extension_class(gd.library, &name, &parent, &info);
    for (const gd_method *method = of->methods; method->name != NULL; method++) add_method(&name, method);
    for (const gd_property *property = of->properties; property->field.name != NULL; property++) add_property(&name, property);
    for (const gd_signal *signal = of->signals; signal->name != NULL; signal++) add_signal(&name, signal);
    for (const gd_constant *constant = of->constants; constant->name != NULL; constant++) add_constant(&name, constant);
    gd_name_free(&name);
    gd_name_free(&parent);
}

void gd_unregister(const gd_class *of)
{
    gd_name name = gd_name_of(of->name);
    gd.classdb_unregister_extension_class(gd.library, &name);
    gd_name_free(&name);
}

void *gd_create(const gd_class *of, void *instance)
{
    static const gd_binding_callbacks callbacks = { NULL, NULL, NULL };
    gd_name name = gd_name_of(of->name), parent = gd_name_of(of->parent);
    void *object = gd.classdb_construct_object(&parent);

    gd.object_set_instance(object, &name, instance);
    gd.object_set_instance_binding(object, gd.library, instance, &callbacks);
    gd_name_free(&name);
    gd_name_free(&parent);
    return object;
}

void *gd_instance_of(void *object) { return object != NULL ? gd.object_get_instance_binding(object, gd.library, NULL) : NULL; }
