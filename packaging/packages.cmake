# Debian packages by `./go package`: blocks (program, manual, decks), libblocks-dev and
# python3-blocks.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL program library)
if(TARGET blocks_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "The BLOCKS authors <blocks@users.noreply.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME blocks)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS python3-h5py)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, libblocks-dev")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Rock as an assembly of polygonal blocks, rigid or simply deformable, that move
under gravity, pressure and impact, collide corner to edge, slide and rub. The
geometry is exact: every layer of blocks is certified, every contact decided
exactly, results are the same bits from run to run.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libblocks-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libcairo2-dev, libdxflib-dev, libeigen3-dev, libfmt-dev, \
libgmp-dev, libhdf5-dev, libmpfr-dev, zlib1g-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "blocks, cmake")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "The library, for C++ programs that drive a model of blocks(1)
step by step: one header, a static library, find_package(blocks), examples.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-blocks)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(TARGET blocks_python)
  math(EXPR next_minor "${BLOCKS_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${BLOCKS_PYTHON_MAJOR}.${BLOCKS_PYTHON_MINOR}), \
python3 (<< ${BLOCKS_PYTHON_MAJOR}.${next_minor}), python3-numpy, python3-h5py")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "blocks, python3-matplotlib, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-scipy, jupyter-notebook")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python package: runs, models driven step by step, results as
NumPy arrays, figures, layers and joints with their certificate, and the exact
predicates on arrays.")

# What Debian wants to find beside each package's files.
configure_file(changelog.Debian.in changelog.Debian @ONLY)
foreach(log CHANGELOG.md:changelog changelog.Debian:changelog.Debian)
  string(REPLACE : \; log ${log})
  list(POP_FRONT log from)
  find_file(source_of_${log} ${from} NO_CACHE NO_DEFAULT_PATH REQUIRED
    PATHS ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR})
  add_custom_command(OUTPUT ${log}.gz
    COMMAND gzip -9nc ${source_of_${log}} > ${log}.gz
    DEPENDS ${source_of_${log}})
  list(APPEND logs ${CMAKE_CURRENT_BINARY_DIR}/${log}.gz)
endforeach()
add_custom_target(package_logs ALL DEPENDS ${logs})
foreach(component program:blocks library:libblocks-dev python:python3-blocks)
  string(REPLACE : \; component ${component})
  list(POP_FRONT component name)
  install(FILES copyright ${logs} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${component}
    COMPONENT ${name})
endforeach()

include(CPack)
