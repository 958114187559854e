/* The entry of the extension: football_init in football.gdextension. */
#include "football.h"

#include "documentation.h"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

static int registered;

static void initialize(void *userdata, int32_t level)
{
    (void)userdata;
    if (level == GD_LEVEL_SCENE && gd_check_precision() && gd_find_methods()) {
        name_signals();
        gd_register(&scene_class);
        gd_register(&ball_class);
        registered = 1;
    }
    if (level == GD_LEVEL_EDITOR && registered && gd.editor_help_load_xml_from_utf8_chars_and_len != NULL) {
        gd.editor_help_load_xml_from_utf8_chars_and_len((const char *)scene_documentation, (int64_t)sizeof scene_documentation);
        gd.editor_help_load_xml_from_utf8_chars_and_len((const char *)ball_documentation, (int64_t)sizeof ball_documentation);
    }
}

static void deinitialize(void *userdata, int32_t level)
{
    (void)userdata;
    if (level != GD_LEVEL_SCENE || !registered) return;
    gd_unregister(&ball_class);
    gd_unregister(&scene_class);
    free_signal_names();
    free_default_scene();
    registered = 0;
}

EXPORT uint8_t football_init(gd_get_function get, void *library, gd_initialization *initialization);

EXPORT uint8_t football_init(gd_get_function get, void *library, gd_initialization *initialization)
{
    if (!gd_load(get, library)) return 0;
    if (FOOTBALL_CHECK_ABI() != FP_OK) {
        gd_report("football_init", "The extension was built for another version of football_physics. Build both again.");
        return 0;
    }
    initialization->minimum_level = GD_LEVEL_SCENE;
    initialization->userdata = NULL;
    initialization->initialize = initialize;
    initialization->deinitialize = deinitialize;
    return 1;
}
