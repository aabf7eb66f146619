# The robot, installed: its programs, and below share/coppice/robot what they read, in the folders
# that it has in the sources (robot_app/common/shipped.h): so ${config}/../../trees of robot.yaml is
# the same there. Programs that are not built are left out.
set(programs)
foreach(name supervisor processes remote robot demo deployment simulator simulated-cameras
        velocity-mux navigation docking localization odometry-filter map-server mapping map slam
        node-monitor topic-monitor navigation-monitor power-monitor system-monitor
        health-aggregator people camera assistance knowledge expression face tablet questionnaire
        speech store)
  if(TARGET coppice-${name})
    list(APPEND programs coppice-${name})
    list(APPEND told ${name})
  endif()
endforeach()
install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT robot OPTIONAL)

set(robot ${CMAKE_INSTALL_DATADIR}/coppice/robot)
set(kinds)
foreach(kind xml test.json)
  list(APPEND kinds trees/*.${kind})
endforeach()
foreach(kind css csv html ics js json pgm rviz urdf xml yaml yml zip)
  list(APPEND kinds robot_app/*.${kind})
endforeach()
file(GLOB_RECURSE read_files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${kinds})
foreach(file ${read_files} robot_app/slam/data/vocabulary.txt)
  get_filename_component(folder ${file} DIRECTORY)
  install(FILES ${file} DESTINATION ${robot}/${folder} COMPONENT robot)
endforeach()

# Debian's three.js stays where it is.
install(CODE "file(MAKE_DIRECTORY
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${robot}/robot_app/tablet/www\")
  file(CREATE_LINK /usr/share/javascript/three/three.min.js
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${robot}/robot_app/tablet/www/three.min.js\" SYMBOLIC)"
  COMPONENT robot)

# The unit, with the folders of this installation.
install(CODE "file(READ ${PROJECT_SOURCE_DIR}/robot_app/config/coppice-supervisor.service unit)
  string(REPLACE /opt/coppice/bin \${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR} unit \"\${unit}\")
  string(REPLACE /opt/coppice/robot_app \${CMAKE_INSTALL_PREFIX}/${robot}/robot_app unit \"\${unit}\")
  file(WRITE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/coppice-supervisor.service\"
       \"\${unit}\")" COMPONENT robot)

coppice_install_papers(robot coppice-robot)
if(HELP2MAN)
  coppice_install_made(robot told.sh ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${told})
endif()
