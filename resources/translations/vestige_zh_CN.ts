<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>ParameterHelp</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Range: %1; default: %2.</source>
        <translation>范围：%1；默认：%2。</translation>
    </message>
    <message>
        <source>Default: %1.</source>
        <translation>默认：%1。</translation>
    </message>
</context>
<context>
    <name>PointClass</name>
    <message>
        <source>never classified</source>
        <translation>从未分类</translation>
    </message>
    <message>
        <source>unclassified</source>
        <translation>未分类</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>low vegetation</source>
        <translation>低矮植被</translation>
    </message>
    <message>
        <source>medium vegetation</source>
        <translation>中等高度植被</translation>
    </message>
    <message>
        <source>high vegetation</source>
        <translation>高大植被</translation>
    </message>
    <message>
        <source>building</source>
        <translation>建筑物</translation>
    </message>
    <message>
        <source>low noise</source>
        <translation>低位噪声点</translation>
    </message>
    <message>
        <source>model key point</source>
        <translation>模型关键点</translation>
    </message>
    <message>
        <source>water</source>
        <translation>水体</translation>
    </message>
    <message>
        <source>rail</source>
        <translation>铁轨</translation>
    </message>
    <message>
        <source>road surface</source>
        <translation>路面</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重叠区</translation>
    </message>
    <message>
        <source>wire, guard</source>
        <translation>架空地线</translation>
    </message>
    <message>
        <source>wire, conductor</source>
        <translation>导线</translation>
    </message>
    <message>
        <source>transmission tower</source>
        <translation>输电塔</translation>
    </message>
    <message>
        <source>wire connector</source>
        <translation>导线连接件</translation>
    </message>
    <message>
        <source>bridge deck</source>
        <translation>桥面</translation>
    </message>
    <message>
        <source>high noise</source>
        <translation>高位噪声点</translation>
    </message>
    <message>
        <source>overhead structure</source>
        <translation>架空构筑物</translation>
    </message>
    <message>
        <source>ignored ground</source>
        <translation>忽略的地面</translation>
    </message>
    <message>
        <source>snow</source>
        <translation>积雪</translation>
    </message>
    <message>
        <source>temporal exclusion</source>
        <translation>时间性排除</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Score at each voxel size (lower is better)</source>
        <translation>各级体素尺寸的得分（越低越好）</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>voxel</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>trust radius</source>
        <translation>信赖域半径</translation>
    </message>
    <message>
        <source>step (hollow: not taken)</source>
        <translation>步长（空心：未采用）</translation>
    </message>
    <message>
        <source>distance to the target&apos;s surface, %1</source>
        <translation>到目标表面的距离，%1</translation>
    </message>
    <message>
        <source>%1 points further off</source>
        <translation>另有 %1 个点更远</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>a sentence that core says</comment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>Nothing is excluded: the errors are systematic, their mean is %1 %.</source>
        <translation>未剔除任何对象：误差为系统误差，其平均值为 %1 %。</translation>
    </message>
    <message>
        <source>No object lies beyond 2 SD.</source>
        <translation>没有对象超出 2 倍标准差。</translation>
    </message>
    <message>
        <source>Beyond 2 SD and excluded: %1.</source>
        <translation>超出 2 倍标准差而被剔除：%1。</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>hashed</source>
        <translation>已计算哈希</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>未改变</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>被触碰</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>已改变</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>step %1%2</source>
        <translation>步长 %1%2</translation>
    </message>
    <message>
        <source>, not taken</source>
        <translation>，未采用</translation>
    </message>
    <message>
        <source>start of this size</source>
        <translation>本级尺寸的起点</translation>
    </message>
    <message>
        <source>Voxels %1 · trust radius %2 · %3 · score %4</source>
        <translation>体素 %1 · 信赖域半径 %2 · %3 · 得分 %4</translation>
    </message>
    <message>
        <source>(not held at all)</source>
        <translation>（完全没有约束）</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>not held</source>
        <translation>没有约束</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重叠度</translation>
    </message>
    <message>
        <source>RMS distance</source>
        <translation>均方根距离</translation>
    </message>
    <message>
        <source>RMS to planes</source>
        <translation>到平面的均方根</translation>
    </message>
    <message>
        <source>iterations, converged</source>
        <translation>次迭代，已收敛</translation>
    </message>
    <message>
        <source>iterations, not converged</source>
        <translation>次迭代，未收敛</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Turn about</source>
        <translation>绕轴转角</translation>
    </message>
    <message>
        <source>Nothing: the data hold the pose in all six directions.</source>
        <translation>无：数据在全部六个方向上都约束了位姿。</translation>
    </message>
    <message>
        <source>Least held: %1 %2.</source>
        <translation>约束最弱：%1 %2。</translation>
    </message>
    <message>
        <source>None of %1 restarts from perturbed poses came back to this place.</source>
        <translation>从扰动位姿重新开始的 %1 次计算无一回到此处。</translation>
    </message>
    <message>
        <source>%1 of %2 restarts from perturbed poses came back to this place, %3.</source>
        <translation>从扰动位姿重新开始的 %2 次计算中有 %1 次回到此处，%3。</translation>
    </message>
    <message>
        <source>within less than 0.1 mm and 0.001°</source>
        <translation>相差不到 0.1 mm 和 0.001°</translation>
    </message>
    <message>
        <source>within %1 and %2°</source>
        <translation>相差不超过 %1 和 %2°</translation>
    </message>
    <message>
        <source>1: the best</source>
        <translation>1：最佳</translation>
    </message>
    <message>
        <source>%1: %2 and %3° from the best</source>
        <translation>%1：与最佳者相差 %2 和 %3°</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>unit not given</source>
        <translation>未给出单位</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>every %1 point</source>
        <translation>每 %1 个点取一个</translation>
    </message>
    <message>
        <source>a part of the file</source>
        <translation>文件的一部分</translation>
    </message>
    <message>
        <source>first look, the rest is being read</source>
        <translation>初览，其余部分正在读取</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>已配准</translation>
    </message>
    <message>
        <source>Repeats  %1 m</source>
        <translation>各次测量  %1 m</translation>
    </message>
    <message>
        <source>    SD %1</source>
        <translation>    标准差 %1</translation>
    </message>
    <message>
        <source>improved NDT</source>
        <translation>改进 NDT</translation>
    </message>
    <message>
        <source>classic NDT</source>
        <translation>经典 NDT</translation>
    </message>
    <message>
        <source>ICP</source>
        <translation>ICP</translation>
    </message>
    <message>
        <source>Registration: add a second scan to align it with the first.</source>
        <translation>配准：再添加一个扫描，使其与第一个对齐。</translation>
    </message>
    <message>
        <source>Not registered yet. Register (Ctrl+G) aligns the other layers with the target.</source>
        <translation>尚未配准。“配准”(Ctrl+G) 使其他图层与目标对齐。</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>可接受</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Ambiguous</source>
        <translation>不唯一</translation>
    </message>
    <message>
        <source>The pose can be relied on, within its uncertainty.</source>
        <translation>该位姿在其不确定度范围内可以信赖。</translation>
    </message>
    <message>
        <source>The layer was moved; use the pose only if the reasons below do not matter.</source>
        <translation>图层已移动；仅当下列理由无关紧要时才可使用该位姿。</translation>
    </message>
    <message>
        <source>There is no pose to rely on; the layer was not moved.</source>
        <translation>没有可信赖的位姿；图层未移动。</translation>
    </message>
    <message>
        <source>Several places fit alike; the layer was not moved. Choose one below.</source>
        <translation>多处位置吻合程度相同；图层未移动。请在下方选择其一。</translation>
    </message>
    <message>
        <source>About Vestige</source>
        <translation>关于 Vestige</translation>
    </message>
    <message>
        <source>&lt;b&gt;Vestige %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Vestige %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Rebuilds road-accident scenes from aerial and handheld laser scans and measures them.

The method: Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171.</source>
        <translation>根据机载和手持激光扫描重建道路交通事故现场，并进行测量。

方法：Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Two tints</source>
        <translation>双色</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高程</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>What the points&apos; colour shows</source>
        <translation>点的颜色表示什么</translation>
    </message>
    <message>
        <source>Compare two pictures of the scene: swipe, blink, checkerboard</source>
        <translation>比较现场的两幅画面：卷帘、闪烁、棋盘格</translation>
    </message>
    <message>
        <source>All scans</source>
        <translation>所有扫描</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Open case</source>
        <translation>打开案件</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>案件</translation>
    </message>
    <message>
        <source>Add clouds and meshes</source>
        <translation>添加点云和网格</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>保存案件</translation>
    </message>
    <message>
        <source>Vestige case</source>
        <translation>Vestige 案件</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>报告文件夹</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes of &quot;%1&quot; first?</source>
        <translation>是否先保存“%1”的更改？</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>It does not fit, and this format is read whole; save it as LAS or LAZ elsewhere.</source>
        <translation>内存放不下，而此格式只能整体读取；请在别处将其另存为 LAS 或 LAZ。</translation>
    </message>
    <message>
        <source>It does not fit; one point in %1 would.</source>
        <translation>内存放不下；每 %1 个点取一个则可以。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the items of a list</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>told once it is loaded</source>
        <translation>载入后得知</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Least corner</source>
        <translation>最小角点</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考系</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Written by</source>
        <translation>生成软件</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>Damage</source>
        <translation>损坏</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Select a file to see what is in it.</source>
        <translation>选择一个文件以查看其内容。</translation>
    </message>
    <message>
        <source>Looking into it...</source>
        <translation>正在查看……</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>导出为 CSV</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Save shortcut sheet</source>
        <translation>保存快捷键表</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Turn about the point under the cursor</source>
        <translation>绕光标处的点旋转</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>right or middle drag</source>
        <translation>右键或中键拖动</translation>
    </message>
    <message>
        <source>Zoom to the cursor</source>
        <translation>向光标处缩放</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Vestige shortcuts</source>
        <translation>Vestige 快捷键</translation>
    </message>
    <message>
        <source>no scans yet</source>
        <translation>尚无扫描</translation>
    </message>
    <message>
        <source>Add the scans of the scene; the first is the frame of all others.</source>
        <translation>请添加现场的扫描；第一个扫描为所有其他扫描的基准。</translation>
    </message>
    <message>
        <source>%1 was not read</source>
        <translation>%1 未读取</translation>
    </message>
    <message>
        <source>%1 files were not read</source>
        <translation>%1 个文件未读取</translation>
    </message>
    <message>
        <source>%1 is still being read</source>
        <translation>%1 仍在读取</translation>
    </message>
    <message>
        <source>%1 files are still being read</source>
        <translation>%1 个文件仍在读取</translation>
    </message>
    <message>
        <source>1 scan, %1 points</source>
        <translation>1 个扫描，%1 个点</translation>
    </message>
    <message>
        <source>%1 scans, %2 points</source>
        <translation>%1 个扫描，%2 个点</translation>
    </message>
    <message>
        <source>Comes after the scans are read.</source>
        <translation>须先读取扫描。</translation>
    </message>
    <message>
        <source>no layer is the target</source>
        <translation>没有目标图层</translation>
    </message>
    <message>
        <source>%1 is not registered</source>
        <translation>%1 尚未配准</translation>
    </message>
    <message>
        <source>%1 scans are not registered</source>
        <translation>%1 个扫描尚未配准</translation>
    </message>
    <message>
        <source>the fit of %1 is doubtful</source>
        <translation>%1 的配准存疑</translation>
    </message>
    <message>
        <source>%1 fits are doubtful</source>
        <translation>%1 个配准存疑</translation>
    </message>
    <message>
        <source>One scan: there is nothing to align.</source>
        <translation>只有一个扫描：无需对齐。</translation>
    </message>
    <message>
        <source>No scan needs to be registered.</source>
        <translation>没有需要配准的扫描。</translation>
    </message>
    <message>
        <source>1 scan is registered.</source>
        <translation>1 个扫描已配准。</translation>
    </message>
    <message>
        <source>%1 scans are registered.</source>
        <translation>%1 个扫描已配准。</translation>
    </message>
    <message>
        <source>Optional: take away what disturbs, separate objects.</source>
        <translation>可选：移除干扰物，分离物体。</translation>
    </message>
    <message>
        <source>%1 layers cleaned, %2 objects separated.</source>
        <translation>已清理 %1 个图层，已分离 %2 个物体。</translation>
    </message>
    <message>
        <source>nothing is measured yet</source>
        <translation>尚未测量任何对象</translation>
    </message>
    <message>
        <source>%1 has recorded aims to take</source>
        <translation>%1 有记录的点选待采用</translation>
    </message>
    <message>
        <source>%1 objects have recorded aims to take</source>
        <translation>%1 个对象有记录的点选待采用</translation>
    </message>
    <message>
        <source>%1 is not measured</source>
        <translation>%1 尚未测量</translation>
    </message>
    <message>
        <source>%1 objects are not measured</source>
        <translation>%1 个对象尚未测量</translation>
    </message>
    <message>
        <source>%1 has fewer than 3 repeats</source>
        <translation>%1 的测量不足 3 次</translation>
    </message>
    <message>
        <source>%1 objects have fewer than 3 repeats</source>
        <translation>%1 个对象的测量不足 3 次</translation>
    </message>
    <message>
        <source>1 object</source>
        <translation>1 个对象</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 个对象</translation>
    </message>
    <message>
        <source>Comes after something is measured.</source>
        <translation>须先进行测量。</translation>
    </message>
    <message>
        <source>%1 has no tape value</source>
        <translation>%1 没有卷尺值</translation>
    </message>
    <message>
        <source>%1 objects without a tape value</source>
        <translation>%1 个对象没有卷尺值</translation>
    </message>
    <message>
        <source>no operator is named</source>
        <translation>未填写操作人员</translation>
    </message>
    <message>
        <source>not written yet</source>
        <translation>尚未生成</translation>
    </message>
    <message>
        <source>Written, and nothing has changed since.</source>
        <translation>已生成，此后没有任何更改。</translation>
    </message>
    <message>
        <source>Not written of the case as it is.</source>
        <translation>尚未按案件的当前状态生成。</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>清理</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>95 % interval: %1 %2</source>
        <translation>95 % 区间：%1 %2</translation>
    </message>
    <message>
        <source>Repeats: %1</source>
        <translation>各次测量：%1</translation>
    </message>
    <message>
        <source>u = %1, degrees of freedom %2, k = %3</source>
        <translation>u = %1，自由度 %2，k = %3</translation>
    </message>
    <message>
        <source>One repeat only: its scatter is not known, so there is no U.</source>
        <translation>只有一次测量：其离散未知，因此没有 U。</translation>
    </message>
    <message>
        <source>%1: standard uncertainty %2 (%3, degrees of freedom %4), which makes %5 of the figure</source>
        <translation>%1：标准不确定度 %2（%3，自由度 %4），对该量的贡献为 %5</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>%1, taken for it</source>
        <translation>%1，按此采用</translation>
    </message>
    <message>
        <source>Loaded</source>
        <translation>载入情况</translation>
    </message>
    <message>
        <source>once all of it is read</source>
        <translation>全部读取后给出</translation>
    </message>
    <message>
        <source>shown; its square, or Space, hides it</source>
        <translation>已显示；单击其方块或按空格键可隐藏</translation>
    </message>
    <message>
        <source>hidden; its square, or Space, shows it</source>
        <translation>已隐藏；单击其方块或按空格键可显示</translation>
    </message>
    <message>
        <source>Files of a report</source>
        <translation>报告的文件</translation>
    </message>
    <message>
        <source>method, lengths, errors, pictures</source>
        <translation>方法、长度、误差、图片</translation>
    </message>
    <message>
        <source>every length, every digit</source>
        <translation>每个长度，全部位数</translation>
    </message>
    <message>
        <source>errors by method</source>
        <translation>各方法的误差</translation>
    </message>
    <message>
        <source>poses and what they are worth</source>
        <translation>位姿及其可信程度</translation>
    </message>
    <message>
        <source>all registered scans as one cloud</source>
        <translation>所有已配准的扫描合成的一个点云</translation>
    </message>
    <message>
        <source>the scene and each object</source>
        <translation>现场和每个对象</translation>
    </message>
    <message>
        <source>hashes of inputs and outputs</source>
        <translation>输入和输出文件的哈希值</translation>
    </message>
    <message>
        <source>not in report</source>
        <translation>不在报告中</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Measure something else: heights, angles, lines, arcs, areas, crush ...</source>
        <translation>测量其他内容：高度、角度、折线、圆弧、面积、变形量……</translation>
    </message>
    <message>
        <source>Kinds of measurement</source>
        <translation>测量类型</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨天 %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, being fitted</source>
        <translation>%1，正在拟合</translation>
    </message>
    <message>
        <source>no point here</source>
        <translation>此处没有点</translation>
    </message>
    <message>
        <source>no %1 here</source>
        <translation>此处没有%1</translation>
    </message>
    <message>
        <source>point, spacing %1</source>
        <translation>点，间距 %1</translation>
    </message>
    <message>
        <source>circle, ⌀ %1 m, σ %2</source>
        <translation>圆，⌀ %1 m，σ %2</translation>
    </message>
    <message>
        <source>%1, σ %2</source>
        <translation>%1，σ %2</translation>
    </message>
    <message>
        <source>1 repeat: %1 m</source>
        <translation>1 次测量：%1 m</translation>
    </message>
    <message>
        <source>%1 repeats: mean %2 m, SD %3</source>
        <translation>%1 次测量：平均值 %2 m，标准差 %3</translation>
    </message>
    <message>
        <source>; the last one %1 from the mean of the others</source>
        <translation>；最后一次与其余各次平均值相差 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>1 repeat, %1</source>
        <translation>1 次测量，%1</translation>
    </message>
    <message>
        <source>%1 repeats, %2, SD %3</source>
        <translation>%1 次测量，%2，标准差 %3</translation>
    </message>
    <message>
        <source>every figure of every kind</source>
        <translation>每种测量的全部数值</translation>
    </message>
    <message>
        <source>what each uncertainty is made of</source>
        <translation>各不确定度的构成</translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>1 s left</source>
        <translation>还剩 1 s</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>还剩 %1 s</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>还剩约 %1 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>还剩 %1 min</translation>
    </message>
</context>
<context>
    <name>vestige::AccuracyPanel</name>
    <message>
        <source>Relative error by object</source>
        <translation>各对象的相对误差</translation>
    </message>
    <message>
        <source>Appears once a measured object has a tape value.</source>
        <translation>有对象测得且有卷尺值后显示。</translation>
    </message>
    <message>
        <source>RMSE of RE, %1 of %2</source>
        <translation>相对误差的 RMSE，%2 个中的 %1 个</translation>
    </message>
    <message>
        <source>RMSE of all %1</source>
        <translation>全部 %1 个的 RMSE</translation>
    </message>
    <message>
        <source>RMSE in length</source>
        <translation>长度的 RMSE</translation>
    </message>
</context>
<context>
    <name>vestige::AlignPanel</name>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Denoise and downsample</source>
        <translation>去噪与降采样</translation>
    </message>
</context>
<context>
    <name>vestige::Attempts</name>
    <message>
        <source>Preview of a pose that was refused; the layer was not moved</source>
        <translation>预览被拒绝的位姿；图层未移动</translation>
    </message>
    <message>
        <source>Preview of candidate %1 of %2; the layer was not moved</source>
        <translation>预览第 %1 个候选位姿，共 %2 个；图层未移动</translation>
    </message>
</context>
<context>
    <name>vestige::Autosave</name>
    <message>
        <source>the last changes (%1) are not stored: %2</source>
        <translation>最后的更改（%1 项）未能存储：%2</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>磁盘没有响应</translation>
    </message>
    <message>
        <source>Autosaving works again.</source>
        <translation>自动保存恢复正常。</translation>
    </message>
    <message>
        <source>Autosaving…</source>
        <translation>正在自动保存……</translation>
    </message>
    <message>
        <source>Autosaved in your own folder: %1</source>
        <translation>已自动保存到您自己的文件夹：%1</translation>
    </message>
    <message>
        <source>Autosave failed: %1</source>
        <translation>自动保存失败：%1</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>所有更改均已保存</translation>
    </message>
    <message>
        <source>All changes autosaved</source>
        <translation>所有更改均已自动保存</translation>
    </message>
    <message>
        <source>The disk does not answer: changes that were not saved may be offered once more.</source>
        <translation>磁盘没有响应：未保存的更改可能会再次提供恢复。</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存……</translation>
    </message>
</context>
<context>
    <name>vestige::BudgetPanel</name>
    <message>
        <source>Selected object</source>
        <translation>所选对象</translation>
    </message>
    <message>
        <source>Select an object in the table to see its figures and what their uncertainty is made of.</source>
        <translation>在表中选择一个对象，查看其各项数值及其不确定度的构成。</translation>
    </message>
    <message>
        <source>Kind of measurement</source>
        <translation>测量类型</translation>
    </message>
    <message>
        <source>Tolerance of the known distance, metres</source>
        <translation>已知距离的允差，以米为单位</translation>
    </message>
    <message>
        <source>How far the measured length may differ from the tape; metres above 0, usually %1</source>
        <translation>测量长度与卷尺值允许相差多少；大于 0 的米数，通常为 %1</translation>
    </message>
    <message>
        <source>within ±</source>
        <translation>允差 ±</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tolerance: expected metres above 0, such as 0.02.</source>
        <translation>“%1”不是允差：应为大于 0 的米数，例如 0.02。</translation>
    </message>
    <message>
        <source>. Choose its tool above the view and click; three repeats make a measurement.</source>
        <translation>。请在视图上方选择其工具并单击；重复三次构成一次测量。</translation>
    </message>
    <message>
        <source>What is measured of the selected object</source>
        <translation>对所选对象测量什么</translation>
    </message>
</context>
<context>
    <name>vestige::CaseForm</name>
    <message>
        <source>How the case is called in the report</source>
        <translation>案件在报告中的名称</translation>
    </message>
    <message>
        <source>Case 2025-0317, open road</source>
        <translation>案件 2025-0317，开阔路段</translation>
    </message>
    <message>
        <source>Who answers for the report</source>
        <translation>对报告负责的人员</translation>
    </message>
    <message>
        <source>Name of the analyst</source>
        <translation>分析人员姓名</translation>
    </message>
    <message>
        <source>WGS 84, -90 to 90; only with the longitude</source>
        <translation>WGS 84，-90 至 90；须与经度一并填写</translation>
    </message>
    <message>
        <source>WGS 84, -180 to 180; only with the latitude</source>
        <translation>WGS 84，-180 至 180；须与纬度一并填写</translation>
    </message>
    <message>
        <source>Above the sea, -500 to 9000; 0 where nothing is given</source>
        <translation>海拔，-500 至 9000；未填写时为 0</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作人员</translation>
    </message>
    <message>
        <source>Latitude, °</source>
        <translation>纬度，°</translation>
    </message>
    <message>
        <source>Longitude, °</source>
        <translation>经度，°</translation>
    </message>
    <message>
        <source>Height, m</source>
        <translation>高程，m</translation>
    </message>
    <message>
        <source>The place is not taken: the latitude is -90 to 90 degrees, the longitude -180 to 180, the height -500 to 9000 metres, each with &apos;.&apos;.</source>
        <translation>未采用该地点：纬度应为 -90 至 90 度，经度应为 -180 至 180 度，高程应为 -500 至 9000 米，均以“.”作小数点。</translation>
    </message>
</context>
<context>
    <name>vestige::CleanPanel</name>
    <message>
        <source>Select by hand</source>
        <translation>手动选择</translation>
    </message>
    <message>
        <source>Draw round what does not belong to the scene: a passer-by, a moving car.</source>
        <translation>圈出不属于现场的内容：路过的行人、行驶中的车辆。</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>离群点</translation>
    </message>
    <message>
        <source>Single points in the air: echoes of rain, dust and edges.</source>
        <translation>空中的孤立点：雨滴、灰尘和边缘产生的回波。</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>The surface that everything else stands on.</source>
        <translation>其他一切物体所在的表面。</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>What stands on the ground and hangs together becomes an object: vehicles, debris, poles.</source>
        <translation>立于地面且连成一体的点成为一个物体：车辆、散落物、杆柱。</translation>
    </message>
    <message>
        <source>Taken out</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>未选择任何点</translation>
    </message>
    <message>
        <source>Draw round points with the lasso (T), or let a step find them. What is selected is shown in magenta; then remove it, keep only it, or make it an object.</source>
        <translation>用套索 (T) 圈选点，或由某一步骤查找。所选的点以品红色显示；然后可移除、仅保留，或设为一个物体。</translation>
    </message>
    <message>
        <source>%1 points selected</source>
        <translation>已选择 %1 个点</translation>
    </message>
    <message>
        <source> of %1 layers</source>
        <translation>，来自 %1 个图层</translation>
    </message>
    <message>
        <source>By %1, from %2 m to %3 m from the eye</source>
        <translation>方式：%1，距观察点 %2 m 至 %3 m</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>方式：%1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%2 %1 个</translation>
    </message>
    <message>
        <source>%1: %2 of %3 points (%4)</source>
        <translation>%1：共 %3 个点，已移除 %2 个（%4）</translation>
    </message>
    <message>
        <source>Nothing yet. The files keep every point whatever is taken out here.</source>
        <translation>暂无。无论此处移除什么，文件都保留每一个点。</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>Up to %1 of them lie more than 1 m behind what is seen from there. A Depth leaves them out; none takes everything under the outline.</source>
        <translation>其中至多 %1 个点位于所见表面之后 1 m 以上。设置“深度”可将其排除；不设则取轮廓下的全部点。</translation>
    </message>
</context>
<context>
    <name>vestige::Cleaner</name>
    <message>
        <source>. They were not taken out; Bring back forgets the cleaning.</source>
        <translation>。这些点未被移除；“恢复已移除的点”可取消清理。</translation>
    </message>
    <message>
        <source>Taking points out of %1</source>
        <translation>正在从 %1 移除点</translation>
    </message>
</context>
<context>
    <name>vestige::CleaningReactions</name>
    <message>
        <source>remove %1 points</source>
        <translation>移除 %1 个点</translation>
    </message>
    <message>
        <source>%1 points are taken out of the scene; their files keep them. Undo brings them back.</source>
        <translation>已从现场移除 %1 个点；其文件仍保留这些点。可用“撤销”恢复。</translation>
    </message>
    <message>
        <source>bring removed points back</source>
        <translation>恢复已移除的点</translation>
    </message>
    <message>
        <source>No points are selected that are still in the scene.</source>
        <translation>所选的点均已不在现场中。</translation>
    </message>
    <message>
        <source>No layer is loaded and shown.</source>
        <translation>没有已载入且显示的图层。</translation>
    </message>
    <message>
        <source>Finding outliers</source>
        <translation>正在查找离群点</translation>
    </message>
    <message>
        <source>%1 outliers are selected; Delete takes them out.</source>
        <translation>已选择 %1 个离群点；按 Delete 键移除。</translation>
    </message>
    <message>
        <source>No layer is loaded.</source>
        <translation>没有已载入的图层。</translation>
    </message>
    <message>
        <source>Finding the ground of %1</source>
        <translation>正在查找 %1 的地面</translation>
    </message>
    <message>
        <source>%1 points of the ground are selected.</source>
        <translation>已选择 %1 个地面点。</translation>
    </message>
    <message>
        <source>Separating what stands on the ground of %1</source>
        <translation>正在分离 %1 地面上的物体</translation>
    </message>
    <message>
        <source>separate objects of %1</source>
        <translation>分离 %1 的物体</translation>
    </message>
    <message>
        <source>Nothing of the sizes asked for stands on the ground.</source>
        <translation>地面上没有符合所设尺寸的物体。</translation>
    </message>
    <message>
        <source>The %1 largest of %2 objects are listed; smaller limits give fewer.</source>
        <translation>已列出 %2 个物体中最大的 %1 个；减小限值可使数量减少。</translation>
    </message>
    <message>
        <source>%1 objects are listed at the left.</source>
        <translation>左侧已列出 %1 个物体。</translation>
    </message>
    <message>
        <source>Making an object</source>
        <translation>正在设为物体</translation>
    </message>
    <message>
        <source>make an object</source>
        <translation>设为物体</translation>
    </message>
    <message>
        <source>%1 is of points that are not loaded.</source>
        <translation>%1 的点未载入。</translation>
    </message>
</context>
<context>
    <name>vestige::CleaningTools</name>
    <message>
        <source>The points are still being read; select when all are there.</source>
        <translation>点仍在读取；请待全部读取后再选择。</translation>
    </message>
    <message>
        <source>Select a layer first, or let the outline take all that are shown.</source>
        <translation>请先选择一个图层，或将圈选范围设为所有显示的图层。</translation>
    </message>
    <message>
        <source>No layer is shown.</source>
        <translation>没有显示的图层。</translation>
    </message>
    <message>
        <source>Selecting points</source>
        <translation>正在选择点</translation>
    </message>
    <message>
        <source>No point lies there.</source>
        <translation>该处没有点。</translation>
    </message>
    <message>
        <source>up to %1 of the points selected lie behind what is seen; a Depth leaves them out</source>
        <translation>所选点中至多有 %1 个位于所见表面之后；设置“深度”可将其排除</translation>
    </message>
</context>
<context>
    <name>vestige::CloudMeasuring</name>
    <message>
        <source>Measuring in the clouds</source>
        <translation>正在点云中测量</translation>
    </message>
</context>
<context>
    <name>vestige::ColorBar</name>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>These colours have no range: choose height, intensity or distance.</source>
        <translation>这种着色没有取值范围：请选择高程、强度或距离。</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation>翠绿 (Viridis)</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>蓝黄 (Cividis)</translation>
    </message>
    <message>
        <source>Plasma</source>
        <translation>紫黄 (Plasma)</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰度</translation>
    </message>
    <message>
        <source>Colours of heights</source>
        <translation>高程的颜色</translation>
    </message>
    <message>
        <source>Colours of heights; equal steps of them look equal. Cividis looks alike to nearly every eye</source>
        <translation>高程的颜色；相等的高差看起来差别也相等。“蓝黄 (Cividis)”对几乎所有人的眼睛都一样</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>最低</translation>
    </message>
    <message>
        <source>Where the colours begin</source>
        <translation>颜色的起点</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最高</translation>
    </message>
    <message>
        <source>Where the colours end</source>
        <translation>颜色的终点</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>舍去</translation>
    </message>
    <message>
        <source>Share of the values left out at either end: 0 to 40 %. Goes back to a range from the values</source>
        <translation>两端各舍去的数值比例：0 至 40 %。范围将重新由数值求得</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Distance, m</source>
        <translation>距离，m</translation>
    </message>
    <message>
        <source>Height, m</source>
        <translation>高程，m</translation>
    </message>
</context>
<context>
    <name>vestige::CompareBar</name>
    <message>
        <source>Size of the tiles (Left, Right)</source>
        <translation>方格大小（左、右方向键）</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 像素</translation>
    </message>
    <message>
        <source>Time of each picture (Left, Right); Space holds one</source>
        <translation>每幅画面的时间（左、右方向键）；空格键停住</translation>
    </message>
    <message>
        <source>held</source>
        <translation>停住</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>调节量</translation>
    </message>
    <message>
        <source>Back to the plain view</source>
        <translation>返回普通视图</translation>
    </message>
</context>
<context>
    <name>vestige::Comparison</name>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>源</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
</context>
<context>
    <name>vestige::Document</name>
    <message>
        <source>Untitled case</source>
        <translation>未命名案件</translation>
    </message>
</context>
<context>
    <name>vestige::EditReactions</name>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做 %1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
</context>
<context>
    <name>vestige::EmptyCasePage</name>
    <message>
        <source>A new case</source>
        <translation>新案件</translation>
    </message>
    <message>
        <source>Add the scans of the scene, the aerial cloud first: it becomes the frame that all others are registered to. Files can also be dropped here.</source>
        <translation>请添加现场的扫描，先添加航测点云：它将成为所有其他扫描配准的基准。也可将文件拖放到此处。</translation>
    </message>
    <message>
        <source>For the report, now or later</source>
        <translation>报告所需信息，可现在或以后填写</translation>
    </message>
</context>
<context>
    <name>vestige::EventWatch</name>
    <message>
        <source>The window was held for at most %1 ms by one of %2 events; longest drawing call %3 ms</source>
        <translation>在 %2 个事件中，窗口最长一次被占用 %1 ms；最长的一次绘图调用为 %3 ms</translation>
    </message>
    <message>
        <source>%1 ms (%2 times): %3</source>
        <translation>%1 ms（%2 次）：%3</translation>
    </message>
</context>
<context>
    <name>vestige::Evidence</name>
    <message>
        <source>%1 was changed by another program after it was read (layer &apos;%2&apos;). The case still shows what was read; Verify evidence tells whether the content differs.</source>
        <translation>%1 在读取后被另一程序更改（图层“%2”）。案件仍显示当时读取的内容；“核验证据”可查明内容是否不同。</translation>
    </message>
    <message>
        <source>%1 is gone since it was read (layer &apos;%2&apos;). The case still shows what was read.</source>
        <translation>%1 在读取后消失（图层“%2”）。案件仍显示当时读取的内容。</translation>
    </message>
    <message>
        <source>Verifying evidence</source>
        <translation>正在核验证据</translation>
    </message>
    <message>
        <source>Every file is the one that was read (SHA-256).</source>
        <translation>每个文件都与当时读取的一致（SHA-256）。</translation>
    </message>
    <message>
        <source>%1 of the files differ from what was read.</source>
        <translation>有 %1 个文件与当时读取的不同。</translation>
    </message>
</context>
<context>
    <name>vestige::EvidencePanel</name>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>Files are hashed (SHA-256) as they are read.</source>
        <translation>文件在读取时计算哈希值（SHA-256）。</translation>
    </message>
</context>
<context>
    <name>vestige::ExchangeReactions</name>
    <message>
        <source>Import picks</source>
        <translation>导入点选</translation>
    </message>
    <message>
        <source>Import tape values</source>
        <translation>导入卷尺值</translation>
    </message>
    <message>
        <source>%1 has corresponding points: select the layer that they belong to, which is not the target, and import them again.</source>
        <translation>%1 含有对应点：请选择这些点所属的图层（不能是目标图层），然后重新导入。</translation>
    </message>
    <message>
        <source>%1 now starts from these pairs; Register (Ctrl+G) goes on from there.</source>
        <translation>%1 现以这些点对为起点；“配准”(Ctrl+G) 由此继续。</translation>
    </message>
    <message>
        <source>The case has all of these picks already.</source>
        <translation>案件已有全部这些点选。</translation>
    </message>
    <message>
        <source>import picks</source>
        <translation>导入点选</translation>
    </message>
    <message>
        <source>%1 repeats of %2 were taken.</source>
        <translation>已采用 %2 的 %1 次测量。</translation>
    </message>
    <message>
        <source>%1 repeats of %2 objects were taken.</source>
        <translation>已采用 %2 个对象的 %1 次测量。</translation>
    </message>
    <message>
        <source>%1 were there already.</source>
        <translation>有 %1 次此前已存在。</translation>
    </message>
    <message>
        <source>The case has all of these values already.</source>
        <translation>案件已有全部这些值。</translation>
    </message>
    <message>
        <source>import tape values</source>
        <translation>导入卷尺值</translation>
    </message>
    <message>
        <source>%1 objects were added or changed. Measured lengths come of picks and were not taken.</source>
        <translation>已添加或更改 %1 个对象。测量长度由点选得出，未予采用。</translation>
    </message>
    <message>
        <source>The picks are in %1.</source>
        <translation>点选已存入 %1。</translation>
    </message>
</context>
<context>
    <name>vestige::ExportReactions</name>
    <message>
        <source>Writing the report</source>
        <translation>正在生成报告</translation>
    </message>
    <message>
        <source>The report and %1 files are in %2.</source>
        <translation>报告和 %1 个文件已存入 %2。</translation>
    </message>
    <message>
        <source>The measurements are in %1.</source>
        <translation>测量结果已存入 %1。</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>The measurements are in %1, every figure of each object in %2, what its uncertainty is made of in %3.</source>
        <translation>测量值在 %1 中，各对象的全部数值在 %2 中，其不确定度的组成在 %3 中。</translation>
    </message>
</context>
<context>
    <name>vestige::FiguresTree</name>
    <message>
        <source>Figures and uncertainty budgets</source>
        <translation>各项数值及不确定度分量</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>U 95 %</source>
        <translation>U 95 %</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
</context>
<context>
    <name>vestige::FileReactions</name>
    <message>
        <source>This case was never saved, so there is nothing to reopen.</source>
        <translation>本案件从未保存，没有可重新打开的内容。</translation>
    </message>
    <message>
        <source>This case cannot be saved here: %1. Choose another name.</source>
        <translation>案件无法保存在此处：%1。请换一个名称。</translation>
    </message>
    <message>
        <source>Waiting for the disk to take the case…</source>
        <translation>正在等待磁盘写入案件……</translation>
    </message>
</context>
<context>
    <name>vestige::FitCurve</name>
    <message>
        <source>Score, voxel size, trust radius and step at each iteration; click to see one</source>
        <translation>每次迭代的得分、体素尺寸、信赖域半径和步长；单击查看其中一次</translation>
    </message>
</context>
<context>
    <name>vestige::FitPanel</name>
    <message>
        <source>Nothing is registered yet. Register (Ctrl+G) aligns the other layers with the target; here it then says how far to trust it.</source>
        <translation>尚未进行配准。“配准”(Ctrl+G) 使其他图层与目标对齐；随后此处说明其可信程度。</translation>
    </message>
    <message>
        <source>A click shows the layer there, without moving it</source>
        <translation>单击可在该处显示图层，而不移动它</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候选位姿</translation>
    </message>
    <message>
        <source>Uncertainty of the pose, 95 %</source>
        <translation>位姿不确定度，95 %</translation>
    </message>
    <message>
        <source>What the data leave free</source>
        <translation>数据未能约束的方向</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>%1 % fit</source>
        <translation>吻合 %1 %</translation>
    </message>
</context>
<context>
    <name>vestige::FitTrace</name>
    <message>
        <source>%1: size %2 of %3, voxels %4 m, iteration %5</source>
        <translation>%1：第 %2 级，共 %3 级，体素 %4 m，第 %5 次迭代</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>正在配准</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
</context>
<context>
    <name>vestige::FitTraceView</name>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Not watched. Switch on “Watch the fit” (W) and register again.</source>
        <translation>未观察。请打开“观察配准”(W) 后重新配准。</translation>
    </message>
    <message>
        <source>Shows the layer where the fit had it at this iteration</source>
        <translation>在该次迭代所处的位置显示图层</translation>
    </message>
    <message>
        <source>Shows all iterations one after the other; Esc ends it</source>
        <translation>依次显示所有迭代；Esc 结束</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>迭代</translation>
    </message>
</context>
<context>
    <name>vestige::GuidePage</name>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Return finds the next place, Shift+Return the one before</source>
        <translation>回车键查找下一处，Shift+回车键查找上一处</translation>
    </message>
    <message>
        <source>Place before</source>
        <translation>上一处</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>下一处</translation>
    </message>
    <message>
        <source>Contents of the page</source>
        <translation>本页目录</translation>
    </message>
    <message>
        <source>Search the page</source>
        <translation>在本页中搜索</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>文档</translation>
    </message>
</context>
<context>
    <name>vestige::HeaderBar</name>
    <message>
        <source>read-only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>saved %1</source>
        <translation>已于 %1 保存</translation>
    </message>
    <message>
        <source>The case is saved as it is</source>
        <translation>案件已按当前状态保存</translation>
    </message>
    <message>
        <source>Save case (Ctrl+S) makes what you see the case</source>
        <translation>“保存案件”(Ctrl+S) 将当前所见内容存为案件</translation>
    </message>
    <message>
        <source>not saved, changes kept %1</source>
        <translation>未保存，更改已于 %1 暂存</translation>
    </message>
</context>
<context>
    <name>vestige::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>关闭历史记录</translation>
    </message>
    <message>
        <source>A click takes the case to that step</source>
        <translation>单击可使案件回到该步</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>the present step</source>
        <translation>当前步骤</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已执行</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
</context>
<context>
    <name>vestige::ImportPanel</name>
    <message>
        <source>Add the scans of the scene: clouds and meshes, by this button or dropped into the window. The first is the frame that the others are registered to. Files are only ever read; each is hashed.</source>
        <translation>请添加现场的扫描：点云和网格，可用此按钮添加或拖放到窗口中。第一个扫描为其他扫描配准的基准。文件只会被读取；每个文件都计算哈希值。</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
</context>
<context>
    <name>vestige::KindReactions</name>
    <message>
        <source>Type the known distance into the tape column of &quot;%1&quot;; its tolerance stands below the table.</source>
        <translation>请将已知距离填入“%1”的卷尺列；其允差在表格下方。</translation>
    </message>
</context>
<context>
    <name>vestige::LayerForm</name>
    <message>
        <source>Select a layer to see what it is.</source>
        <translation>选择一个图层以查看其信息。</translation>
    </message>
    <message>
        <source>recognise</source>
        <translation>自动识别</translation>
    </message>
    <message>
        <source>where the file has it</source>
        <translation>文件所给的位置</translation>
    </message>
    <message>
        <source>pose or picks of the case</source>
        <translation>案件中的位姿或点对</translation>
    </message>
    <message>
        <source>found automatically</source>
        <translation>自动查找</translation>
    </message>
    <message>
        <source>Where the registration of this layer starts. Found automatically: anywhere in the target, whatever the layer&apos;s pose and unit</source>
        <translation>该图层的配准从何处开始。自动查找：在目标中的任意位置，不论图层的位姿和单位</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>How the layer is called in the window and in the report</source>
        <translation>图层在窗口和报告中的名称</translation>
    </message>
    <message>
        <source>What made the scan: it says how precise it is, and what is registered</source>
        <translation>扫描的来源：说明其精密程度以及哪些需要配准</translation>
    </message>
    <message>
        <source>What the file&apos;s coordinates are in; recognised from the file where nothing is chosen</source>
        <translation>文件坐标的单位；未选择时由文件自动识别</translation>
    </message>
</context>
<context>
    <name>vestige::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>None yet. Drop scans here.</source>
        <translation>暂无。请将扫描拖放到此处。</translation>
    </message>
</context>
<context>
    <name>vestige::Loader</name>
    <message>
        <source>Recovering a case</source>
        <translation>正在恢复案件</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>another</source>
        <translation>另一个案件</translation>
    </message>
    <message>
        <source>%1 was changed while it was opened again. These changes are in place, as one step that Undo takes back.</source>
        <translation>%1 在重新打开期间被更改。这些更改已作为一步恢复，可用“撤销”取消。</translation>
    </message>
    <message>
        <source>The case before was changed while %1 was read. These changes are kept and offered the next time.</source>
        <translation>读取 %1 期间原案件被更改。这些更改已保留，下次将提供恢复。</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 个文件</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Cancelled; every layer was read.</source>
        <translation>已取消；所有图层均已读取。</translation>
    </message>
    <message>
        <source>Cancelled; 1 layer was not read.</source>
        <translation>已取消；有 1 个图层未读取。</translation>
    </message>
    <message>
        <source>Cancelled; %1 layers were not read.</source>
        <translation>已取消；有 %1 个图层未读取。</translation>
    </message>
    <message>
        <source>Load what is whole</source>
        <translation>载入完好的部分</translation>
    </message>
    <message>
        <source>Load what is whole of %1</source>
        <translation>载入 %1 中完好的部分</translation>
    </message>
    <message>
        <source>Load every %1 point</source>
        <translation>每 %1 个点载入一个</translation>
    </message>
    <message>
        <source>Load only where the other layers are</source>
        <translation>仅载入其他图层所在的部分</translation>
    </message>
    <message>
        <source>%1: %2. It was not read.</source>
        <translation>%1：%2。未读取。</translation>
    </message>
    <message>
        <source>Looking for changes that were not saved</source>
        <translation>正在查找未保存的更改</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation>（%1）</translation>
    </message>
</context>
<context>
    <name>vestige::Loupe</name>
    <message>
        <source>Loupe</source>
        <translation>放大镜</translation>
    </message>
</context>
<context>
    <name>vestige::MainWindow</name>
    <message>
        <source>Read-only: %1.</source>
        <translation>只读：%1。</translation>
    </message>
</context>
<context>
    <name>vestige::MeasureTool</name>
    <message>
        <source>New object</source>
        <translation>新对象</translation>
    </message>
    <message>
        <source>repeat %1 of 3</source>
        <translation>第 %1 次，共 3 次</translation>
    </message>
    <message>
        <source>repeat %1</source>
        <translation>第 %1 次</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>click the second end %1, Esc gives up</source>
        <translation>单击第二个端点，%1；按 Esc 放弃</translation>
    </message>
    <message>
        <source>click the first end %1</source>
        <translation>单击第一个端点，%1</translation>
    </message>
    <message>
        <source>What is found is drawn before the click. N: the next kind of snap.</source>
        <translation>单击之前即画出所找到的特征。N 键：切换到下一种捕捉。</translation>
    </message>
    <message>
        <source>that is the first end: click the other one</source>
        <translation>这就是第一个端点：请单击另一个端点</translation>
    </message>
</context>
<context>
    <name>vestige::MeasurementsModel</name>
    <message>
        <source>no tape</source>
        <translation>无卷尺值</translation>
    </message>
    <message>
        <source>Repeats %1 m</source>
        <translation>各次测量 %1 m</translation>
    </message>
    <message>
        <source>Repeat SD %1 m</source>
        <translation>重复标准差 %1 m</translation>
    </message>
    <message>
        <source>The tape itself is good to %1 m (1 SD)</source>
        <translation>卷尺自身的标准不确定度为 %1 m（1 倍标准差）</translation>
    </message>
    <message>
        <source>Excluded from RMSE: |RE| is beyond 2 SD</source>
        <translation>已从 RMSE 中剔除：|RE| 超出 2 倍标准差</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Tape m</source>
        <translation>卷尺 m</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>U 95 %</source>
        <translation>U 95 %</translation>
    </message>
    <message>
        <source>RE %</source>
        <translation>RE %</translation>
    </message>
    <message>
        <source>There is already an object called &quot;%1&quot;.</source>
        <translation>已有名为“%1”的对象。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tape length: expected metres above 0, such as 4.78.</source>
        <translation>“%1”不是卷尺长度：应为大于 0 的米数，例如 4.78。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>A known distance: it may be off by %1 m</source>
        <translation>已知距离：允许相差 %1 m</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no reference: expected a number above 0, in %2.</source>
        <translation>“%1”不是参考值：应为大于 0 的数，单位为 %2。</translation>
    </message>
</context>
<context>
    <name>vestige::MeasurementsPanel</name>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>No lengths yet.

Choose Distance above the view and click the two ends of an object, three times. Then type what the tape says.</source>
        <translation>尚无长度。

请在视图上方选择“距离”，单击对象的两个端点，共三次。然后输入卷尺读数。</translation>
    </message>
    <message>
        <source>The method whose figures are shown</source>
        <translation>显示其数据的测量方法</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>测量方法</translation>
    </message>
    <message>
        <source>Not verified: no known distance of this method has been checked. Mark an object whose length is known as &quot;Known distance&quot;.</source>
        <translation>未校核：尚未用此方法校核任何已知距离。请将一个长度已知的对象标为“已知距离”。</translation>
    </message>
    <message>
        <source>Verified: the known distance agrees within its tolerance.</source>
        <translation>已校核：已知距离在允差范围内相符。</translation>
    </message>
    <message>
        <source>CHECK FAILED:</source>
        <translation>校核不合格：</translation>
    </message>
    <message>
        <source> %1 is off by %2, %3 allowed.</source>
        <translation>%1 相差 %2，允许 %3。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
</context>
<context>
    <name>vestige::NoticeBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
</context>
<context>
    <name>vestige::Notices</name>
    <message>
        <source>Cancelled; nothing was changed.</source>
        <translation>已取消；未作任何更改。</translation>
    </message>
</context>
<context>
    <name>vestige::ObjectsPanel</name>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>尚未测量。</translation>
    </message>
    <message>
        <source>%1 of 3</source>
        <translation>%1 / 3</translation>
    </message>
</context>
<context>
    <name>vestige::OutlineTool</name>
    <message>
        <source>Drag a box round points. Shift adds, Ctrl takes away; Alt+drag turns the view</source>
        <translation>拖动方框框选点。Shift 加选，Ctrl 减选；Alt+拖动可旋转视图</translation>
    </message>
    <message>
        <source>Let go, or click the opposite corner; Esc gives up</source>
        <translation>松开鼠标，或单击对角；按 Esc 放弃</translation>
    </message>
    <message>
        <source>Click round points, or draw round them. Shift adds, Ctrl takes away; Alt+drag turns the view</source>
        <translation>依次单击圈出点，或拖动圈画。Shift 加选，Ctrl 减选；Alt+拖动可旋转视图</translation>
    </message>
    <message>
        <source>%1 corners: double-click, Return or right-click closes, Backspace takes one back, Esc gives up</source>
        <translation>%1 个顶点：双击、回车键或右键单击闭合，Backspace 退回一个，Esc 放弃</translation>
    </message>
</context>
<context>
    <name>vestige::ParameterEditor</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>vestige::ParameterForm</name>
    <message>
        <source>Show or hide what an expert may want to change</source>
        <translation>显示或隐藏专家可能要修改的参数</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 项</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 个参数</translation>
    </message>
    <message>
        <source>%1, all at their defaults</source>
        <translation>%1，均为默认值</translation>
    </message>
    <message>
        <source>%1, %2 changed</source>
        <translation>%1，已修改 %2 项</translation>
    </message>
</context>
<context>
    <name>vestige::PartsPanel</name>
    <message>
        <source>vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>debris</source>
        <translation>散落物</translation>
    </message>
    <message>
        <source>pole or plant</source>
        <translation>杆柱或植物</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>%1: %2, %3 points of %4</source>
        <translation>%1：%2，%3 个点，来自 %4</translation>
    </message>
    <message>
        <source>%1 m, the upright box round its points; no measurement</source>
        <translation>%1 m，包围其各点的直立长方体；并非测量结果</translation>
    </message>
    <message>
        <source>Its points are of another file or part than the one that is loaded.</source>
        <translation>其点属于另一文件或另一部分，与所载入的不同。</translation>
    </message>
    <message>
        <source>Parts of the scene</source>
        <translation>现场物体</translation>
    </message>
    <message>
        <source>None yet. Clean (Ctrl+4) separates vehicles and debris.</source>
        <translation>暂无。“清理”(Ctrl+4) 可分离车辆和散落物。</translation>
    </message>
    <message>
        <source>Tick to show, double-click to rename</source>
        <translation>勾选可显示，双击可重命名</translation>
    </message>
    <message>
        <source>It is: %1</source>
        <translation>类别：%1</translation>
    </message>
</context>
<context>
    <name>vestige::PathTool</name>
    <message>
        <source>A path has %1 points at most.</source>
        <translation>一条路径最多有 %1 个点。</translation>
    </message>
    <message>
        <source>This needs %1 points or more; there are %2. Esc gives up.</source>
        <translation>此处至少需要 %1 个点；现有 %2 个。按 Esc 放弃。</translation>
    </message>
    <message>
        <source>pick %1, repeat 1</source>
        <translation>点选 %1，第 1 次</translation>
    </message>
    <message>
        <source>New: %1</source>
        <translation>新建：%1</translation>
    </message>
    <message>
        <source>repeat %1 of 3</source>
        <translation>第 %1 次，共 3 次</translation>
    </message>
    <message>
        <source>repeat %1</source>
        <translation>第 %1 次</translation>
    </message>
    <message>
        <source>; double click or Enter ends</source>
        <translation>；双击或回车键结束</translation>
    </message>
    <message>
        <source>; Backspace takes the last point back, Esc gives up</source>
        <translation>；Backspace 退回上一点，Esc 放弃</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>click %1 %2</source>
        <translation>单击%1，%2</translation>
    </message>
    <message>
        <source>N: the next kind of snap, such as an edge or a corner.</source>
        <translation>N 键：切换到下一种捕捉，如边或角点。</translation>
    </message>
    <message>
        <source>What is found is drawn before the click. N: the next kind of snap.</source>
        <translation>单击之前即画出所找到的特征。N 键：切换到下一种捕捉。</translation>
    </message>
</context>
<context>
    <name>vestige::PickChoices</name>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>highest</source>
        <translation>最高点</translation>
    </message>
    <message>
        <source>lowest</source>
        <translation>最低点</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>centroid</source>
        <translation>质心</translation>
    </message>
    <message>
        <source>at the nearest point</source>
        <translation>取最近点</translation>
    </message>
    <message>
        <source>on the local plane</source>
        <translation>取局部平面上的点</translation>
    </message>
    <message>
        <source>on an edge</source>
        <translation>取边缘上的点</translation>
    </message>
    <message>
        <source>at a corner</source>
        <translation>取角点</translation>
    </message>
    <message>
        <source>at the highest point</source>
        <translation>取最高点</translation>
    </message>
    <message>
        <source>at the lowest point</source>
        <translation>取最低点</translation>
    </message>
    <message>
        <source>at a circle&apos;s centre</source>
        <translation>取圆心</translation>
    </message>
    <message>
        <source>at the centroid</source>
        <translation>取质心</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>on the surface seen</source>
        <translation>取所见表面</translation>
    </message>
</context>
<context>
    <name>vestige::PickMover</name>
    <message>
        <source>This repeat counts for %1, the point here for %2: measure it as a repeat of its own.</source>
        <translation>这次测量计入 %1，而此处的点属于 %2：请将其作为单独一次测量。</translation>
    </message>
    <message>
        <source>Moving an end of repeat %1: %2, was %3 m. Esc puts it back.</source>
        <translation>正在移动第 %1 次测量的端点：%2，原为 %3 m。按 Esc 恢复原位。</translation>
    </message>
    <message>
        <source>Moving point %1 of repeat %2: %3 m from where it was. Esc puts it back.</source>
        <translation>正在移动第 %2 次测量的第 %1 个点：距原位置 %3 m。按 Esc 恢复原位。</translation>
    </message>
</context>
<context>
    <name>vestige::PickProbe</name>
    <message>
        <source>There is no point within 6 pixels of the cursor.</source>
        <translation>光标的 6 像素范围内没有点。</translation>
    </message>
    <message>
        <source>Features can be fitted once all points of this layer are read.</source>
        <translation>须待此图层的点全部读取后才能拟合特征。</translation>
    </message>
    <message>
        <source>Points of photogrammetry err together, which no fit averages out: snap to points.</source>
        <translation>摄影测量的点误差相关，拟合无法将其平均掉：请捕捉到点。</translation>
    </message>
</context>
<context>
    <name>vestige::PictureBar</name>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>True to scale, 1 :</source>
        <translation>按比例尺，1 :</translation>
    </message>
    <message>
        <source>No background</source>
        <translation>无背景</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>图片宽度</translation>
    </message>
    <message>
        <source>Width, 16 to 32000 pixels</source>
        <translation>宽度，16 至 32000 像素</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>图片高度</translation>
    </message>
    <message>
        <source>Height, 16 to 32000 pixels</source>
        <translation>高度，16 至 32000 像素</translation>
    </message>
    <message>
        <source>Scale of the picture, 1 to</source>
        <translation>图片比例尺，1 比</translation>
    </message>
    <message>
        <source>100: a metre of the scene is a centimetre on paper. The view is drawn parallel</source>
        <translation>100：现场 1 米在纸上为 1 厘米。视图以平行投影绘制</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>每英寸点数</translation>
    </message>
    <message>
        <source>Dots per inch, 36 to 2400: written into the file; letters and points grow with them</source>
        <translation>每英寸点数，36 至 2400：写入文件；文字和点随之放大</translation>
    </message>
    <message>
        <source>One length in the picture is one length in the scene, wherever it lies</source>
        <translation>图片中相同的长度即为现场相同的长度，无论位于何处</translation>
    </message>
    <message>
        <source>Where nothing is drawn the picture is transparent</source>
        <translation>未绘制内容的部分为透明</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Choose a PNG file and draw the view into it</source>
        <translation>选择一个 PNG 文件并将视图绘入其中</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>%1 × %2 cm on paper</source>
        <translation>纸上 %1 × %2 cm</translation>
    </message>
    <message>
        <source>shows %1 × %2 m on %3 × %4 cm</source>
        <translation>以 %3 × %4 cm 显示 %1 × %2 m</translation>
    </message>
    <message>
        <source>This program has nothing to draw pictures with.</source>
        <translation>本程序没有可用于绘制图片的组件。</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>正在绘制图片</translation>
    </message>
    <message>
        <source>The picture is in %1.</source>
        <translation>图片已存入 %1。</translation>
    </message>
</context>
<context>
    <name>vestige::RecentMenu</name>
    <message>
        <source>Open recen&amp;t</source>
        <translation>打开最近的案件(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
</context>
<context>
    <name>vestige::RecoveryBar</name>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>稍后决定</translation>
    </message>
    <message>
        <source>A case that was never saved</source>
        <translation>一个从未保存的案件</translation>
    </message>
    <message>
        <source>%1 was open when the program ended: %2.</source>
        <translation>程序结束时 %1 处于打开状态：%2。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>The program ended before this case was saved: %1. They are in place again.</source>
        <translation>程序在本案件保存之前结束：%1。这些更改已恢复。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
</context>
<context>
    <name>vestige::RegistrationReactions</name>
    <message>
        <source>Its iterations were not watched (W).</source>
        <translation>其迭代过程未被观察 (W)。</translation>
    </message>
    <message>
        <source>Registering %1</source>
        <translation>正在配准 %1</translation>
    </message>
    <message>
        <source>%1 was not registered: %2. Choose its start under Align, or Register from any pose (Ctrl+Shift+G).</source>
        <translation>%1 未能配准：%2。请在“对齐”下选择其起点，或使用“从任意位姿配准”(Ctrl+Shift+G)。</translation>
    </message>
    <message>
        <source>%1 was not registered: %2.</source>
        <translation>%1 未能配准：%2。</translation>
    </message>
    <message>
        <source>: %1</source>
        <translation>：%1</translation>
    </message>
    <message>
        <source>%1 was not moved: several places fit alike. Choose one under Fit.</source>
        <translation>%1 未移动：多处位置吻合程度相同。请在“吻合”中选择其一。</translation>
    </message>
    <message>
        <source>%1 was not moved, the registration failed%2. Fit shows what it found.</source>
        <translation>%1 未移动，配准失败%2。“吻合”面板显示其结果。</translation>
    </message>
    <message>
        <source>The registration of %1 is doubtful%2.</source>
        <translation>%1 的配准存疑%2。</translation>
    </message>
    <message>
        <source>Taking recorded aims</source>
        <translation>正在采用记录的点选</translation>
    </message>
</context>
<context>
    <name>vestige::RegistrationStrip</name>
    <message>
        <source>overlap</source>
        <translation>重叠度</translation>
    </message>
    <message>
        <source>RMS distance</source>
        <translation>均方根距离</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>移动量</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>次迭代</translation>
    </message>
    <message>
        <source>voxels, %1 sizes</source>
        <translation>体素，%1 级</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 到 %2</translation>
    </message>
</context>
<context>
    <name>vestige::ReportPanel</name>
    <message>
        <source>Nothing was written in this session. Export report (Ctrl+R) makes a folder.</source>
        <translation>本次运行尚未生成任何内容。“导出报告”(Ctrl+R) 将生成一个文件夹。</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案件</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>尚缺内容</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>报告内容</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>已生成</translation>
    </message>
    <message>
        <source>Outputs of this session</source>
        <translation>本次运行的输出</translation>
    </message>
    <message>
        <source>A double click, or Return, opens it</source>
        <translation>双击或按回车键打开</translation>
    </message>
</context>
<context>
    <name>vestige::ResidualView</name>
    <message>
        <source>%1 points in %2 bars of %3 mm, %4 further off</source>
        <translation>%1 个点，分为 %2 个 %3 mm 的区间，另有 %4 个更远</translation>
    </message>
</context>
<context>
    <name>vestige::SampleReactions</name>
    <message>
        <source>The sample scene is simulated once; that takes some minutes.</source>
        <translation>示例现场只需模拟一次；这需要几分钟。</translation>
    </message>
    <message>
        <source>Simulating the sample scene</source>
        <translation>正在模拟示例现场</translation>
    </message>
</context>
<context>
    <name>vestige::ScenePresenter</name>
    <message>
        <source>Distances to the target</source>
        <translation>到目标的距离</translation>
    </message>
</context>
<context>
    <name>vestige::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Middle of the section, %1</source>
        <translation>剖切中心，%1</translation>
    </message>
    <message>
        <source>%1 of the box&apos;s middle, metres</source>
        <translation>剖切框中心的 %1 坐标，以米为单位</translation>
    </message>
    <message>
        <source>Size of the section, %1</source>
        <translation>剖切大小，%1</translation>
    </message>
    <message>
        <source>Length of the box along its own %1 axis, metres: 0.001 or more; a slab is thin along one of them</source>
        <translation>剖切框沿其自身 %1 轴的长度，以米为单位：不小于 0.001；薄片沿其中一轴很薄</translation>
    </message>
    <message>
        <source>Turn of the section</source>
        <translation>剖切的转角</translation>
    </message>
    <message>
        <source>How the box is turned about its upright axis, from x towards y: -180 to 180 degrees</source>
        <translation>剖切框绕其竖直轴的转角，由 x 向 y：-180 至 180 度</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>转角</translation>
    </message>
</context>
<context>
    <name>vestige::ShortcutsPage</name>
    <message>
        <source>Set</source>
        <translation>设定</translation>
    </message>
    <message>
        <source>Give the chosen action these keys</source>
        <translation>将这些键指定给所选操作</translation>
    </message>
    <message>
        <source>None</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Take the chosen action&apos;s shortcut away</source>
        <translation>取消所选操作的快捷键</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it came with</source>
        <translation>恢复所选操作原有的键</translation>
    </message>
    <message>
        <source>Search actions and keys</source>
        <translation>搜索操作和键</translation>
    </message>
    <message>
        <source>Words of an action, or keys</source>
        <translation>操作中的字词，或键</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>搜索快捷键</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Choose an action to change its shortcut</source>
        <translation>选择一个操作以更改其快捷键</translation>
    </message>
    <message>
        <source>Press the new keys here</source>
        <translation>在此按下新的键</translation>
    </message>
    <message>
        <source>Keys of the chosen action</source>
        <translation>所选操作的键</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Give every action the keys that it came with</source>
        <translation>恢复每个操作原有的键</translation>
    </message>
    <message>
        <source>Changed; it came with %1</source>
        <translation>已更改；原为 %1</translation>
    </message>
    <message>
        <source>Choose an action to change its shortcut.</source>
        <translation>请选择一个操作以更改其快捷键。</translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot;: choose other keys, or take them from it first.</source>
        <translation>%1 属于“%2”：请选择其他键，或先将其从该操作取消。</translation>
    </message>
</context>
<context>
    <name>vestige::SideDock</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>指南</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message>
        <source>Close help</source>
        <translation>关闭帮助</translation>
    </message>
    <message>
        <source>Tutorial</source>
        <translation>教程</translation>
    </message>
</context>
<context>
    <name>vestige::SnapButton</name>
    <message>
        <source>What a pick is taken on (N for the next)</source>
        <translation>点选所捕捉的特征（按 N 键切换到下一种）</translation>
    </message>
    <message>
        <source>Snap: %1</source>
        <translation>捕捉：%1</translation>
    </message>
</context>
<context>
    <name>vestige::StatusStrip</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop this job; the case stays as it was</source>
        <translation>停止此任务；案件保持原状</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Showing %1 of %2 points</source>
        <translation>正在显示 %2 个点中的 %1 个</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>%1 points in one layer</source>
        <translation>%1 个点，1 个图层</translation>
    </message>
    <message>
        <source>%1 points in %2 layers</source>
        <translation>%1 个点，%2 个图层</translation>
    </message>
</context>
<context>
    <name>vestige::StepBar</name>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
</context>
<context>
    <name>vestige::StepButton</name>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>可选</translation>
    </message>
    <message>
        <source>something is missing</source>
        <translation>尚缺内容</translation>
    </message>
    <message>
        <source>comes later</source>
        <translation>须待前面的步骤</translation>
    </message>
    <message>
        <source>Step %1, %2: %3</source>
        <translation>第 %1 步，%2：%3</translation>
    </message>
</context>
<context>
    <name>vestige::StepTabs</name>
    <message>
        <source>Panels of the step</source>
        <translation>该步骤的面板</translation>
    </message>
</context>
<context>
    <name>vestige::StepsList</name>
    <message>
        <source>Nothing is missing.</source>
        <translation>没有尚缺内容。</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>转到“%1”</translation>
    </message>
</context>
<context>
    <name>vestige::ViewBar</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>vestige::ViewsPanel</name>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>保存视图</translation>
    </message>
    <message>
        <source>Named views</source>
        <translation>命名视图</translation>
    </message>
    <message>
        <source>%1 keeps the view in the case, for you and the report.</source>
        <translation>%1 将视图保存在案件中，供您和报告使用。</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>已保存的视图</translation>
    </message>
    <message>
        <source>Click: go there. Double click or F2: rename. Right click: update, scale, report, delete.</source>
        <translation>单击：转到该视图。双击或 F2：重命名。右键单击：更新、比例尺、报告、删除。</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>转到该视图</translation>
    </message>
    <message>
        <source>Replace by what is seen now</source>
        <translation>以当前所见替换</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>In the report</source>
        <translation>纳入报告</translation>
    </message>
    <message>
        <source>Scale in print</source>
        <translation>打印比例尺</translation>
    </message>
    <message>
        <source>As large as the page allows</source>
        <translation>按页面所容最大尺寸</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>vestige::WatchReactions</name>
    <message>
        <source>From now on it is measured how long the window takes to answer. Work on, then choose this again.</source>
        <translation>从现在起测量窗口的响应时间。请继续工作，然后再次选择此项。</translation>
    </message>
</context>
<context>
    <name>vestige::WelcomePage</name>
    <message>
        <source>Open case</source>
        <translation>打开案件</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Cases and scans that you open will stand here.</source>
        <translation>您打开的案件和扫描将列在此处。</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>新建案件</translation>
    </message>
    <message>
        <source>Name it and add its scans</source>
        <translation>为其命名并添加扫描</translation>
    </message>
    <message>
        <source>A saved case, .vestige or case.json</source>
        <translation>已保存的案件，.vestige 或 case.json</translation>
    </message>
    <message>
        <source>Open scans</source>
        <translation>打开扫描</translation>
    </message>
    <message>
        <source>Look at clouds and meshes at once</source>
        <translation>立即查看点云和网格</translation>
    </message>
    <message>
        <source>Sample case</source>
        <translation>示例案件</translation>
    </message>
    <message>
        <source>A night collision with known lengths</source>
        <translation>长度已知的夜间碰撞事故</translation>
    </message>
    <message>
        <source>Recent cases and files</source>
        <translation>最近的案件和文件</translation>
    </message>
    <message>
        <source>A click, or Return, opens it</source>
        <translation>单击或按回车键打开</translation>
    </message>
    <message>
        <source>From scans to a report that stands up in court</source>
        <translation>从扫描到经得起法庭检验的报告</translation>
    </message>
    <message>
        <source>Everything happens on this computer; files are only ever read, and each is hashed. Scans and cases can also be dropped into the window.</source>
        <translation>一切都在本机上进行；文件只会被读取，每个文件都计算哈希值。也可将扫描和案件拖放到窗口中。</translation>
    </message>
    <message>
        <source>Scans of any scanner; the first is the frame</source>
        <translation>任何扫描仪的扫描；第一个为基准</translation>
    </message>
    <message>
        <source>Register them, and see whether the fit is good</source>
        <translation>进行配准，并查看吻合是否良好</translation>
    </message>
    <message>
        <source>Take away what disturbs; the files stay</source>
        <translation>移除干扰物；文件保持不变</translation>
    </message>
    <message>
        <source>Three repeats each, with their uncertainty</source>
        <translation>每项测量三次，并给出不确定度</translation>
    </message>
    <message>
        <source>PDF, tables, pictures and every hash</source>
        <translation>PDF、表格、图片和全部哈希值</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>%1 is not there now. A click takes it off the list.</source>
        <translation>%1 现已不存在。单击可将其从列表中移除。</translation>
    </message>
</context>
<context>
    <name>vestige::WindowReactions</name>
    <message>
        <source>There is no picture yet: add scans first.</source>
        <translation>尚无图片：请先添加扫描。</translation>
    </message>
    <message>
        <source>The view is on the clipboard, %1 × %2 pixels.</source>
        <translation>视图已复制到剪贴板，%1 × %2 像素。</translation>
    </message>
    <message>
        <source>There is nothing to copy: the table is empty.</source>
        <translation>没有可复制的内容：表格为空。</translation>
    </message>
    <message>
        <source>%1 rows are on the clipboard.</source>
        <translation>已将 %1 行复制到剪贴板。</translation>
    </message>
    <message>
        <source>Vestige shortcuts</source>
        <translation>Vestige 快捷键</translation>
    </message>
    <message>
        <source>The shortcuts are in %1.</source>
        <translation>快捷键已存入 %1。</translation>
    </message>
</context>
<context>
    <name>vestige::WorkArea</name>
    <message>
        <source>Fit</source>
        <translation>吻合</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>清理</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Selected object</source>
        <translation>所选对象</translation>
    </message>
</context>
</TS>
