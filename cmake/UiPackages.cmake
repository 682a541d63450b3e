find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets Svg OpenGL Concurrent)
find_package(VTK 9.1 REQUIRED COMPONENTS
    CommonCore CommonDataModel CommonTransforms FiltersCore FiltersGeneral FiltersSources InteractionStyle IOImage
    RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2 GUISupportQt)
