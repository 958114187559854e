/* The parts of Godot's extension interface that this sample calls, declared from its public description: gdextension/gdextension_interface.json
   and "builtin_class_sizes" of extension_api.json in github.com/godotengine/godot-cpp. All parts exist in Godot 4.2 and later. */
#ifndef FOOTBALL_GD_H
#define FOOTBALL_GD_H

#include <stddef.h>
#include <stdint.h>

/* Godot's own builds have single precision. A build of Godot with precision=double needs -DFOOTBALL_GODOT_DOUBLE. */
#ifdef FOOTBALL_GODOT_DOUBLE
typedef double gd_real;
enum { GD_VARIANT_BYTES = 40 };
#else
typedef float gd_real;
enum { GD_VARIANT_BYTES = 24 };
#endif

typedef struct { gd_real x, y, z; } gd_vector3;
typedef struct { gd_real rows[3][3]; gd_vector3 origin; } gd_transform3d;
typedef struct { uint64_t words[GD_VARIANT_BYTES / 8]; } gd_variant;
typedef struct { void *data; } gd_string;
typedef struct { void *data; } gd_name;
typedef struct { void *data[2]; } gd_packed;

/* A value of any type that a method of this sample takes or returns. */
typedef union { uint8_t boolean; int64_t integer; double number; gd_vector3 vector; gd_string text; void *object; gd_packed packed; } gd_value;

/* Variant types. */
enum {
    GD_NIL = 0, GD_BOOL = 1, GD_INT = 2, GD_FLOAT = 3, GD_STRING = 4, GD_VECTOR3 = 9, GD_STRING_NAME = 21, GD_OBJECT = 24, GD_PACKED_BYTES = 29,
    GD_PACKED_VECTOR3 = 36, GD_TYPES = 38
};

enum { GD_HINT_RESOURCE_TYPE = 17, GD_HINT_MULTILINE_TEXT = 18 };
enum { GD_USAGE_NONE = 0, GD_USAGE_DEFAULT = 6, GD_USAGE_CLASS_IS_ENUM = 1 << 16 };
enum { GD_METHOD_NORMAL = 1, GD_METHOD_CONST = 4 };
enum { GD_CALL_OK = 0, GD_CALL_INVALID_ARGUMENT = 2, GD_CALL_TOO_MANY = 3, GD_CALL_TOO_FEW = 4 };
enum { GD_ENTER_TREE = 10, GD_PHYSICS_PROCESS = 16, GD_PROCESS = 17 };
enum { GD_LEVEL_SCENE = 2, GD_LEVEL_EDITOR = 3 };

typedef struct { int32_t error, argument, expected; } gd_error;
typedef struct { uint32_t major, minor, patch; const char *text; } gd_version;

typedef void (*gd_function)(void);
typedef gd_function (*gd_get_function)(const char *name);
typedef void (*gd_convert)(void *to, void *from);
typedef void (*gd_construct)(void *to, const void *const *args);
typedef void (*gd_destroy)(void *value);
typedef void (*gd_call)(void *self, const void *const *args, void *result);

typedef struct { int32_t type; gd_name *name, *class_name; uint32_t hint; gd_string *hint_string; uint32_t usage; } gd_property_info;

typedef struct {
    gd_name *name;
    void *userdata;
    void (*call)(void *userdata, void *self, const void *const *args, int64_t count, void *result, gd_error *error);
    void (*ptrcall)(void *userdata, void *self, const void *const *args, void *result);
    uint32_t flags;
    uint8_t has_return;
    gd_property_info *return_info;
    int32_t return_metadata;
    uint32_t argument_count;
    gd_property_info *arguments;
    int32_t *argument_metadata;
    uint32_t default_count;
    void **defaults;
} gd_method_info;

typedef struct {
    uint8_t is_virtual, is_abstract;
    gd_function set, get, get_property_list, free_property_list, property_can_revert, property_get_revert;
    void (*notification)(void *self, int32_t what);
    gd_function to_string, reference, unreference;
    void *(*create)(void *userdata);
    void (*free)(void *userdata, void *self);
    gd_function get_virtual, get_rid;
    void *userdata;
} gd_class_info;

typedef struct { gd_function create, free, reference; } gd_binding_callbacks;

typedef struct {
    int32_t minimum_level;
    void *userdata;
    void (*initialize)(void *userdata, int32_t level);
    void (*deinitialize)(void *userdata, int32_t level);
} gd_initialization;

/* F(result, name, arguments) for each function of the interface. */
#define GD_INTERFACE(F) \
    F(void, get_godot_version, (gd_version *version)) \
    F(void, print_error_with_message, (const char *description, const char *message, const char *function, const char *file, int32_t line, uint8_t notify)) \
    F(void, string_name_new_with_latin1_chars, (gd_name *to, const char *text, uint8_t is_static)) \
    F(void, string_new_with_utf8_chars, (gd_string *to, const char *text)) \
    F(int64_t, string_to_utf8_chars, (const gd_string *from, char *text, int64_t capacity)) \
    F(void, variant_new_nil, (gd_variant *to)) \
    F(void, variant_destroy, (gd_variant *value)) \
    F(int32_t, variant_get_type, (const gd_variant *value)) \
    F(void, variant_construct, (int32_t type, gd_variant *to, const void *const *args, int32_t count, gd_error *error)) \
    F(void, variant_call, (gd_variant *self, const gd_name *method, const void *const *args, int64_t count, gd_variant *result, gd_error *error)) \
    F(gd_convert, get_variant_from_type_constructor, (int32_t type)) \
    F(gd_convert, get_variant_to_type_constructor, (int32_t type)) \
    F(gd_construct, variant_get_ptr_constructor, (int32_t type, int32_t index)) \
    F(gd_destroy, variant_get_ptr_destructor, (int32_t type)) \
    F(uint8_t *, packed_byte_array_operator_index, (gd_packed *self, int64_t index)) \
    F(const uint8_t *, packed_byte_array_operator_index_const, (const gd_packed *self, int64_t index)) \
    F(gd_vector3 *, packed_vector3_array_operator_index, (gd_packed *self, int64_t index)) \
    F(void, object_method_bind_call, (const void *bind, void *object, const void *const *args, int64_t count, gd_variant *result, gd_error *error)) \
    F(void, object_method_bind_ptrcall, (const void *bind, void *object, const void *const *args, void *result)) \
    F(void *, global_get_singleton, (const gd_name *name)) \
    F(void *, object_get_instance_binding, (void *object, void *token, const gd_binding_callbacks *callbacks)) \
    F(void, object_set_instance_binding, (void *object, void *token, void *binding, const gd_binding_callbacks *callbacks)) \
    F(void, object_set_instance, (void *object, const gd_name *class_name, void *instance)) \
    F(void, ref_set_object, (void *reference, void *object)) \
    F(void *, classdb_construct_object, (const gd_name *class_name)) \
    F(const void *, classdb_get_method_bind, (const gd_name *class_name, const gd_name *method, int64_t hash)) \
    F(void, classdb_register_extension_class, (void *library, const gd_name *name, const gd_name *parent, const gd_class_info *info)) \
    F(void, classdb_register_extension_class_method, (void *library, const gd_name *class_name, const gd_method_info *info)) \
    F(void, classdb_register_extension_class_integer_constant, (void *library, const gd_name *class_name, const gd_name *enumeration, const gd_name *name, int64_t value, uint8_t is_bitfield)) \
    F(void, classdb_register_extension_class_property, (void *library, const gd_name *class_name, const gd_property_info *info, const gd_name *setter, const gd_name *getter)) \
    F(void, classdb_register_extension_class_signal, (void *library, const gd_name *class_name, const gd_name *name, const gd_property_info *arguments, int64_t count)) \
    F(void, classdb_unregister_extension_class, (void *library, const gd_name *class_name))

#define GD_TYPE(result, name, arguments) typedef result (*gd_##name) arguments;
GD_INTERFACE(GD_TYPE)
#undef GD_TYPE

#define GD_MEMBER(result, name, arguments) gd_##name name;
typedef struct {
    GD_INTERFACE(GD_MEMBER)
    /* The documentation of classes: Godot 4.3 and later, in the editor; otherwise null. */
    void (*editor_help_load_xml_from_utf8_chars_and_len)(const char *xml, int64_t bytes);
    void *library;
    gd_convert from[GD_TYPES], to[GD_TYPES];
    gd_destroy destroy[GD_TYPES];
} gd_interface;
#undef GD_MEMBER

extern gd_interface gd;

/* The engine's methods that the sample calls. */
enum {
    GD_EMIT_SIGNAL, GD_GET_GLOBAL_TRANSFORM, GD_SET_GLOBAL_TRANSFORM, GD_SET_INTERPOLATION_MODE, GD_SET_PROCESS, GD_SET_PHYSICS_PROCESS, GD_PHYSICS_DELTA, GD_IS_EDITOR, GD_TICKS_PER_SECOND,
    GD_INTERPOLATION_FRACTION, GD_BINDS
};

enum { GD_MOST_ARGUMENTS = 6 };

/* A parameter, a result or a property. */
typedef struct { const char *name; int32_t type; const char *class_name; uint32_t hint; const char *hint_string; uint32_t usage; } gd_field;

/* A method: its function takes pointers to values. The last `defaults` arguments are numbers, and are 0 if they are not passed. */
typedef struct { const char *name; gd_call call; uint32_t flags; gd_field result; int32_t count, defaults; gd_field arguments[GD_MOST_ARGUMENTS]; } gd_method;

typedef struct { gd_field field; const char *setter, *getter; } gd_property;
typedef struct { const char *name; int32_t count; gd_field arguments[GD_MOST_ARGUMENTS]; } gd_signal;
typedef struct { const char *enumeration, *name; int64_t value; } gd_constant;

/* A class: lists end with an item without a name. */
typedef struct {
    const char *name, *parent;
    void *(*create)(void *userdata);
    void (*free)(void *userdata, void *self);
    void (*notification)(void *self, int32_t what);
    const gd_method *methods;
    const gd_property *properties;
    const gd_signal *signals;
    const gd_constant *constants;
} gd_class;

/* Reads the interface; returns 0 if a function is missing. */
int gd_load(gd_get_function get, void *library);
/* Compares the size of a Vector3 with the engine's; returns 0 if they differ. */
int gd_check_precision(void);
/* Finds the engine's methods; returns 0 if one is missing. */
int gd_find_methods(void);
/* Calls a method of the engine with at most one argument. A method of the singleton Engine has a null object. */
void gd_engine(int method, void *object, const void *argument, void *result);
/* Emits a signal with n values, and frees the values. */
void gd_emit(void *object, const gd_variant *name, gd_variant *values, int32_t n);
/* Reports an error in Godot's debugger. */
void gd_report(const char *function, const char *message);

gd_name gd_name_of(const char *text);
void gd_name_free(gd_name *name);
/* Copies a text; the caller frees it. */
char *gd_text_of(const gd_string *from);
/* Replaces a text that is a result. */
void gd_set_text(void *result, const char *text);
/* Returns the number of items of an array. */
int64_t gd_packed_size(int32_t type, const gd_packed *array);
/* Replaces an array that is a result by one of n items, and returns its items. */
void *gd_set_packed(void *result, int32_t type, int64_t n);

void gd_register(const gd_class *of);
void gd_unregister(const gd_class *of);
/* Creates an object of a class for an instance. */
void *gd_create(const gd_class *of, void *instance);
/* Returns the instance of an object that gd_create created; null for other objects. */
void *gd_instance_of(void *object);

#endif
