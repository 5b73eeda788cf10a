# tuftwave_embed(<target> FILES <file>... [STUDIO <file>...])
#
# A static library that holds the files' bytes, and embedded.inc, which lists them for assets/assets.cpp: those of FILES by
# their bare names, those of STUDIO as studio/<name>, so that neither can hide the other. The assembler takes the files in
# (.incbin), so they need to be there when the target is built, not when CMake runs.
function(tuftwave_embed target)
    cmake_parse_arguments(PARSE_ARGV 1 embed "" "" "FILES;STUDIO")
    set(files ${embed_FILES} ${embed_STUDIO})
    set(directory ${CMAKE_CURRENT_BINARY_DIR}/embedded)
    set(assembly ".section .rodata\n")
    set(list "")
    set(number 0)
    foreach(file IN LISTS files)
        set(symbol tuftwave_asset_${number})
        get_filename_component(name ${file} NAME)
        if(file IN_LIST embed_STUDIO)
            string(PREPEND name studio/)
        endif()
        string(APPEND assembly
            ".balign 16\n.global ${symbol}\n${symbol}:\n.incbin \"${file}\"\n.global ${symbol}_end\n${symbol}_end:\n.byte 0\n")
        string(APPEND list "TUFTWAVE_ASSET(${symbol}, \"${name}\")\n")
        math(EXPR number "${number} + 1")
    endforeach()
    # Without this mark the linker would make the whole program's stack executable.
    string(APPEND assembly ".section .note.GNU-stack,\"\",%progbits\n")
    file(CONFIGURE OUTPUT ${directory}/embedded.S CONTENT "${assembly}" @ONLY)
    file(CONFIGURE OUTPUT ${directory}/embedded.inc CONTENT "${list}" @ONLY)
    set_source_files_properties(${directory}/embedded.S PROPERTIES OBJECT_DEPENDS "${files}")
    add_library(${target} STATIC ${directory}/embedded.S)
    target_include_directories(${target} INTERFACE ${directory})
endfunction()
