# LASzip: the distribution's package, or the prefix that packaging/fetch-laszip.sh filled (build/laszip).
find_path(LASZIP_INCLUDE_DIR laszip/laszip_api.h HINTS "${CMAKE_SOURCE_DIR}/build/laszip/include")
find_library(LASZIP_CORE_LIBRARY NAMES laszip HINTS "${CMAKE_SOURCE_DIR}/build/laszip/lib")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LASzip
    REQUIRED_VARS LASZIP_CORE_LIBRARY LASZIP_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "run packaging/fetch-laszip.sh build/laszip")
if(LASzip_FOUND AND NOT TARGET LASzip::LASzip)
    add_library(LASzip::LASzip INTERFACE IMPORTED)
    set_target_properties(LASzip::LASzip PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${LASZIP_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${LASZIP_CORE_LIBRARY}")
endif()
mark_as_advanced(LASZIP_INCLUDE_DIR LASZIP_CORE_LIBRARY)
