# The program archive of `./go package`: one folder, whose program needs no library and no
# font of the system.
set(archive blocks-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})

# The objects of the program, linked statically. Debian has no static library of fmt.
find_library(STATIC_HDF5 libhdf5.a HINTS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/hdf5/serial)
add_executable(blocks_static EXCLUDE_FROM_ALL fmt_library.cpp $<TARGET_OBJECTS:blocks>)
set_target_properties(blocks_static PROPERTIES
  OUTPUT_NAME blocks RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/static)
target_include_directories(blocks_static PRIVATE
  $<TARGET_PROPERTY:fmt::fmt,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_options(blocks_static PRIVATE -static)
list(TRANSFORM CAIRO_STATIC_LIBRARIES PREPEND "-l" OUTPUT_VARIABLE static_cairo)
list(REMOVE_DUPLICATES static_cairo)
target_link_libraries(blocks_static PRIVATE
  blocks_options $<TARGET_FILE:blocks_core> $<TARGET_FILE:blocks_geometry>
  -Wl,--start-group ${static_cairo} -ldxflib ${STATIC_HDF5} -lsz -laec -lz -lmpfr -lgmp -Wl,--end-group)
add_dependencies(blocks_static blocks_core blocks_geometry)

# install_archived(KIND ...) is install() into the archive only.
macro(install_archived)
  install(${ARGN} COMPONENT archive EXCLUDE_FROM_ALL)
endmacro()

install_archived(TARGETS blocks_static RUNTIME DESTINATION bin)
install_archived(FILES ${CMAKE_CURRENT_BINARY_DIR}/blocks.1.gz DESTINATION share/man/man1)
install_archived(FILES ${CMAKE_CURRENT_BINARY_DIR}/blocks-deck.5.gz DESTINATION share/man/man5)
install_archived(FILES ${CMAKE_CURRENT_BINARY_DIR}/completion/blocks
  DESTINATION share/bash-completion/completions)
install_archived(FILES fonts.conf DESTINATION share/blocks)
install_archived(FILES /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
  DESTINATION share/blocks/fonts)
install_archived(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION .)
install_manual(. archive EXCLUDE_FROM_ALL)

# The licences of all that is linked into the program.
foreach(package fonts-dejavu-core libaec-dev libboost1.74-dev libbrotli-dev libc6-dev
    libcairo2-dev libcgal-dev libcli11-dev libdxflib-dev libeigen3-dev libexpat1-dev libfmt-dev
    libfontconfig-dev libfreetype-dev libgmp-dev libhdf5-dev libmpfr-dev libpixman-1-dev
    libpng-dev librandom123-dev libstdc++-12-dev libx11-dev libxau-dev libxcb1-dev libxdmcp-dev
    libxext-dev libxrender-dev nlohmann-json3-dev zlib1g-dev)
  install_archived(FILES /usr/share/doc/${package}/copyright
    DESTINATION share/doc/licences RENAME ${package} OPTIONAL)
endforeach()

set(unpacked ${CMAKE_CURRENT_BINARY_DIR}/${archive})
add_custom_target(archive
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${unpacked}
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --component archive --strip
    --prefix ${unpacked}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/packages
  COMMAND tar -C ${CMAKE_CURRENT_BINARY_DIR} --owner=0 --group=0 --sort=name
    -czf ${PROJECT_BINARY_DIR}/packages/${archive}.tar.gz ${archive}
  VERBATIM)
add_dependencies(archive blocks_static manual)
