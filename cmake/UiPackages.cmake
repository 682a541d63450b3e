find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets Svg OpenGL Concurrent)
find_package(VTK 9.1 REQUIRED COMPONENTS
    CommonCore CommonDataModel RenderingCore RenderingOpenGL2)
