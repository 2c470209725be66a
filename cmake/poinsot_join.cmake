# poinsot_join(TARGET FILE...): the compiler reads these files of the target as one. They share their headers, on which it
# spends most of its time. -DPOINSOT_JOIN_FILES=OFF switches this off; each file must also compile by itself.
option(POINSOT_JOIN_FILES "Compile files that share their headers together, which saves the compiler much work" ON)

function(poinsot_join target)
  if(NOT TARGET ${target} OR NOT POINSOT_JOIN_FILES OR CMAKE_VERSION VERSION_LESS 3.18)  # 3.18: groups of files
    return()
  endif()
  get_target_property(groups ${target} POINSOT_GROUPS)
  if(NOT groups)
    set(groups 0)
  endif()
  math(EXPR groups "${groups} + 1")
  set_target_properties(${target} PROPERTIES POINSOT_GROUPS ${groups} UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP group_${groups})
endfunction()
