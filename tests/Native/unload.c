/* dlclose leaves the library loaded: the runtime's thread still runs its code. */
#include <dlfcn.h>
#include <stdio.h>

int main(int count, char **arguments)
{
    void *library = count == 2 ? dlopen(arguments[1], RTLD_NOW) : NULL;
    if (!library || !dlsym(library, "fp_version")) { puts(dlerror()); return 1; }
    if (dlclose(library) != 0) { puts(dlerror()); return 1; }
    if (!dlopen(arguments[1], RTLD_NOW | RTLD_NOLOAD)) { puts("dlclose unloads the library"); return 1; }
    puts("dlclose leaves the library loaded");
    return 0;
}
