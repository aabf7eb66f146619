# Packs this build into Debian packages, unpacks them side by side into a folder, as installing does,
# and uses what lies there. Called with -D BUILD, WORK, EDITOR, PYTHON,
# WEB, ROBOT, VERSION.
cmake_minimum_required(VERSION 3.16)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
# Packed quickly: how small they are is not what is tested, and what the robot's many programs depend on takes as long
# as all else; clean_root.sh installs by it.
run(cpack --config ${BUILD}/CPackConfig.cmake -D CPACK_DEBIAN_COMPRESSION_TYPE=zstd
  -D CPACK_DEBIAN_ROBOT_PACKAGE_SHLIBDEPS=OFF -B ${WORK}/packages)
set(expected coppice libcoppice-dev coppice-btcpp-compat)
if(EDITOR)
  list(APPEND expected coppice-editor)
endif()
if(PYTHON)
  list(APPEND expected python3-coppice)
endif()
if(WEB)
  list(APPEND expected coppice-web)
endif()
if(ROBOT)
  list(APPEND expected coppice-robot)
endif()
foreach(name ${expected})
  file(GLOB package ${WORK}/packages/${name}_*.deb)
  run(dpkg-deb --extract ${package} ${WORK}/root)
  run(dpkg-deb --field ${package} Package)
  string(STRIP "${output}" output)
  if(NOT output STREQUAL name)
    message(FATAL_ERROR "${package} calls itself ${output}")
  endif()
endforeach()

file(WRITE ${WORK}/tree.xml [[<root BTCPP_format="4">
  <BehaviorTree ID="Main"><Delay delay_msec="10"><AlwaysSuccess/></Delay></BehaviorTree>
</root>]])
set(bin ${WORK}/root/usr/bin)
set(share ${WORK}/root/usr/share/coppice)
expect("coppice ${VERSION}" ${bin}/coppice --version)
foreach(told man/man1/coppice.1.gz man/man1/coppice-check.1.gz bash-completion/completions/coppice
        doc/coppice/copyright doc/libcoppice-dev/changelog.gz)
  if(NOT EXISTS ${WORK}/root/usr/share/${told})
    message(FATAL_ERROR "no package has ${told}")
  endif()
endforeach()
run(${bin}/coppice run ${WORK}/tree.xml --quiet)
if(PYTHON)
  expect("Status.SUCCESS" ${CMAKE_COMMAND} -E env
         PYTHONPATH=${WORK}/root/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c
         "from coppice import load\nprint(load('${WORK}/tree.xml').run())")
endif()
if(EDITOR)
  run(${bin}/coppice edit ${share}/examples/delivery.xml --headless --picture ${WORK}/delivery.png)
endif()
if(ROBOT)  # it finds what it ships beside itself
  run(${bin}/coppice check --models ${share}/robot/trees/models.xml
      ${share}/robot/trees/monitor/monitor.xml)
  run(${bin}/coppice-deployment run --seeds 1 --days 1 --out ${WORK}/days)
  run(${bin}/coppice-face)
  set(institute ${share}/robot/robot_app/config/sites/institute)  # that the demonstration drives on
  file(STRINGS ${institute}/map.yaml picture REGEX "^image: ")
  string(REPLACE "image: " "" picture "${picture}")
  if(NOT EXISTS ${institute}/${picture})
    message(FATAL_ERROR "the map of the institute has no picture: ${picture}")
  endif()
  file(GLOB_RECURSE units ${WORK}/root/usr/lib/systemd/system/*.service)
  file(STRINGS "${units}" start REGEX ExecStart)
  if(NOT start MATCHES "/usr/bin/coppice-supervisor --config /usr/share/coppice/robot/")
    message(FATAL_ERROR "the unit starts ${start}")
  endif()
endif()
if(WEB)
  expect("in a browser: http://"
         ${bin}/coppice run ${WORK}/tree.xml --quiet --live-port 0 --web --web-port 0)
endif()
