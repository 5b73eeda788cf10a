# tuftwave_embed(<target> <file>...)
#
# A static library that holds the files' bytes, and embedded.inc, which lists them for assets/assets.cpp. The assembler
# takes the files in (.incbin), so they need to be there when the target is built, not when CMake runs.
function(tuftwave_embed target)
    set(directory ${CMAKE_CURRENT_BINARY_DIR}/embedded)
    set(assembly ".section .rodata\n")
    set(list "")
    set(number 0)
    foreach(file IN LISTS ARGN)
        set(symbol tuftwave_asset_${number})
        get_filename_component(name ${file} NAME)
        string(APPEND assembly
            ".balign 16\n.global ${symbol}\n${symbol}:\n.incbin \"${file}\"\n.global ${symbol}_end\n${symbol}_end:\n.byte 0\n")
        string(APPEND list "TUFTWAVE_ASSET(${symbol}, \"${name}\")\n")
        math(EXPR number "${number} + 1")
    endforeach()
    # Without this mark the linker would make the whole program's stack executable.
    string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")
    file(CONFIGURE OUTPUT ${directory}/embedded.S CONTENT "${assembly}" @ONLY)
    file(CONFIGURE OUTPUT ${directory}/embedded.inc CONTENT "${list}" @ONLY)
    set_source_files_properties(${directory}/embedded.S PROPERTIES OBJECT_DEPENDS "${ARGN}")
    add_library(${target} STATIC ${directory}/embedded.S)
    target_include_directories(${target} INTERFACE ${directory})
endfunction()
