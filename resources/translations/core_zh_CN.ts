<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>core/base</name>
    <message>
        <source>US survey feet</source>
        <translation>美国测量英尺</translation>
    </message>
    <message>
        <source>a folder of this name is in the way of the file</source>
        <translation>该文件的位置上有一个同名文件夹</translation>
    </message>
    <message>
        <source>a quoted cell is not closed</source>
        <translation>带引号的单元格没有结束</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>应为%1</translation>
    </message>
    <message>
        <source>expected a comma or the end of the line</source>
        <translation>应为逗号或行尾</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>应为一个数</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>应为一个整数</translation>
    </message>
    <message>
        <source>expected text</source>
        <translation>应为文本</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>应为 true 或 false</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>从 %1 起</translation>
    </message>
    <message>
        <source>is the disk full?</source>
        <translation>磁盘是否已满？</translation>
    </message>
    <message>
        <source>it had %1 bytes and has %2</source>
        <translation>原有 %1 字节，现为 %2 字节</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>它已消失</translation>
    </message>
    <message>
        <source>one of</source>
        <translation>其中之一：</translation>
    </message>
    <message>
        <source>or auto</source>
        <translation>或 auto</translation>
    </message>
    <message>
        <source>reading stopped before the end of the file</source>
        <translation>未读到文件末尾读取就停止了</translation>
    </message>
    <message>
        <source>reading stopped with a device error</source>
        <translation>读取因设备错误而停止</translation>
    </message>
    <message>
        <source>text follows a quoted cell</source>
        <translation>带引号的单元格后面还有文本</translation>
    </message>
    <message>
        <source>the file cannot be opened for reading</source>
        <translation>无法打开文件进行读取</translation>
    </message>
    <message>
        <source>the file cannot be put in place: %1</source>
        <translation>无法将文件放到位：%1</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>the file changed while it was being read</source>
        <translation>文件在读取过程中发生了改变</translation>
    </message>
    <message>
        <source>the file is larger than a file of this kind can be</source>
        <translation>文件大于此类文件可能的大小</translation>
    </message>
    <message>
        <source>the finished file cannot be put in place</source>
        <translation>无法将完成的文件放到位</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>无法创建文件夹：%1</translation>
    </message>
    <message>
        <source>the output folder cannot be made: a file of this name exists</source>
        <translation>无法创建输出文件夹：已存在同名文件</translation>
    </message>
    <message>
        <source>the value '%1' is not allowed for %2</source>
        <translation>值“%1”不允许用于 %2</translation>
    </message>
    <message>
        <source>there is no parameter '%1'</source>
        <translation>没有参数“%1”</translation>
    </message>
    <message>
        <source>there is not enough memory for this step</source>
        <translation>内存不足，无法进行此步骤</translation>
    </message>
    <message>
        <source>this is a device or pipe, a file was expected</source>
        <translation>这是设备或管道，应为文件</translation>
    </message>
    <message>
        <source>this is a folder, a file was expected</source>
        <translation>这是文件夹，应为文件</translation>
    </message>
    <message>
        <source>units of %1 m</source>
        <translation>以 %1 m 为单位</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>至 %1</translation>
    </message>
    <message>
        <source>vestige: this processor lacks AVX2 and FMA (x86-64-v3, built since 2013), which every result is computed with; run it on a newer machine</source>
        <translation>vestige：本机处理器缺少 AVX2 和 FMA 指令集（x86-64-v3，2013 年起生产），而所有结果都用它们计算；请在较新的计算机上运行</translation>
    </message>
    <message>
        <source>what was read is not used; read it again when nothing writes to it any more</source>
        <translation>已读取的内容不予采用；请在不再有程序写入时重新读取</translation>
    </message>
    <message>
        <source>writing failed before the end of the file</source>
        <translation>未写到文件末尾写入就失败了</translation>
    </message>
</context>
<context>
    <name>core/evaluation</name>
    <message>
        <source>%1 line %2</source>
        <translation>%1 第 %2 行</translation>
    </message>
    <message>
        <source>'%1' is not a finite number</source>
        <translation>“%1”不是有限数</translation>
    </message>
    <message>
        <source>expected %1, as the header names</source>
        <translation>应为 %1，如表头所列</translation>
    </message>
    <message>
        <source>expected Hokuyo_N.csv, PointCloudN.csv or clouds of any readable format</source>
        <translation>应为 Hokuyo_N.csv、PointCloudN.csv 或任何可读格式的点云</translation>
    </message>
    <message>
        <source>expected a distance from 1 to %1</source>
        <translation>应为 1 到 %1 的间隔</translation>
    </message>
    <message>
        <source>expected a pose for the number of each cloud</source>
        <translation>应为每个点云的编号各给出一个位姿</translation>
    </message>
    <message>
        <source>expected an ASL pose CSV, or lines t x y z qx qy qz qw</source>
        <translation>应为 ASL 位姿 CSV，或各行为 t x y z qx qy qz qw</translation>
    </message>
    <message>
        <source>expected metres up to 1e10</source>
        <translation>应为不超过 1e10 的米数</translation>
    </message>
    <message>
        <source>expected one pose per cloud</source>
        <translation>应为每个点云一个位姿</translation>
    </message>
    <message>
        <source>expected poseId,timestamp,T00,T01,...,T33</source>
        <translation>应为 poseId,timestamp,T00,T01,...,T33</translation>
    </message>
    <message>
        <source>expected t x y z qx qy qz qw, or the header of an ASL pose file before</source>
        <translation>应为 t x y z qx qy qz qw，或在前面给出 ASL 位姿文件的表头</translation>
    </message>
    <message>
        <source>no poseId belongs to %1</source>
        <translation>没有与 %1 对应的 poseId</translation>
    </message>
    <message>
        <source>no two poses are %1 apart</source>
        <translation>没有相隔 %1 的两个位姿</translation>
    </message>
    <message>
        <source>poseId %1 is not a whole number</source>
        <translation>poseId %1 不是整数</translation>
    </message>
    <message>
        <source>poseId %1 is there twice</source>
        <translation>poseId %1 出现了两次</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>无法读取文件夹</translation>
    </message>
    <message>
        <source>the header has no column %1</source>
        <translation>表头没有 %1 列</translation>
    </message>
    <message>
        <source>the place is farther from 0 than any on Earth</source>
        <translation>该位置到 0 的距离超过地球上任何地点</translation>
    </message>
    <message>
        <source>the quaternion qx qy qz qw does not have length 1</source>
        <translation>四元数 qx qy qz qw 的长度不为 1</translation>
    </message>
    <message>
        <source>there are %1 estimates and %2 known poses</source>
        <translation>有 %1 个估计位姿和 %2 个已知位姿</translation>
    </message>
    <message>
        <source>there are %1 numbers</source>
        <translation>有 %1 个数</translation>
    </message>
    <message>
        <source>there are %1 poses for %2 clouds</source>
        <translation>%2 个点云有 %1 个位姿</translation>
    </message>
    <message>
        <source>there are fewer than two clouds</source>
        <translation>点云少于两个</translation>
    </message>
    <message>
        <source>there are fewer than two poses</source>
        <translation>位姿少于两个</translation>
    </message>
</context>
<context>
    <name>core/filters</name>
    <message>
        <source>A point is an outlier above the mean of these distances plus this many of their standard deviations.</source>
        <translation>某点的平均距离大于这些距离的均值加上这么多倍标准差时，为离群点。</translation>
    </message>
    <message>
        <source>A point this near to the ground's surface is ground; automatic: 3 times the scatter of the points round it, 0.02 m to 0.15 m.</source>
        <translation>离地面这么近的点即为地面；自动：其周围点离散度的 3 倍，限于 0.02 m 到 0.15 m。</translation>
    </message>
    <message>
        <source>A point with fewer others within the radius is an outlier.</source>
        <translation>半径内其他点少于此数的点为离群点。</translation>
    </message>
    <message>
        <source>All layers that are shown, or the selected one alone.</source>
        <translation>所有显示的图层，或仅所选图层。</translation>
    </message>
    <message>
        <source>Anything of fewer points is passed over.</source>
        <translation>点数少于此数者略过。</translation>
    </message>
    <message>
        <source>Anything whose longest side is longer is passed over: buildings, rows of trees.</source>
        <translation>最长边大于此值者略过：建筑物、成排的树木。</translation>
    </message>
    <message>
        <source>Anything whose longest side is shorter is passed over.</source>
        <translation>最长边小于此值者略过。</translation>
    </message>
    <message>
        <source>By distance: an outlier lies above the mean of all mean distances by more than this many of their standard deviations.</source>
        <translation>按距离：平均距离比所有平均距离的均值大出这么多倍标准差以上的点为离群点。</translation>
    </message>
    <message>
        <source>By distance: how many neighbours are asked.</source>
        <translation>按距离：考察多少个邻点。</translation>
    </message>
    <message>
        <source>By number: a point with fewer others within the radius is an outlier.</source>
        <translation>按数量：半径内其他点少于此数的点为离群点。</translation>
    </message>
    <message>
        <source>By number: neighbours lie within this distance; automatic: 3 times the median spacing.</source>
        <translation>按数量：邻点位于此距离之内；自动：点间距中位数的 3 倍。</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Cubes of this edge that touch and hold points belong to one object; three times the spacing of the points or more, and less than what stands apart.</source>
        <translation>以此为边长、含有点且彼此相接的立方体属于同一物体；应不小于点间距的三倍，且小于相互分开的物体之间的距离。</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Edge of the squares whose lowest points begin the search; several points should fall into one.</source>
        <translation>方格的边长，搜索从各方格的最低点开始；每个方格应落入若干点。</translation>
    </message>
    <message>
        <source>Edge of the voxels that are thinned to one point each; automatic: no thinning.</source>
        <translation>每个体素稀释为一个点，此为体素的边长；自动：不稀释。</translation>
    </message>
    <message>
        <source>Fewest neighbours</source>
        <translation>最少邻点数</translation>
    </message>
    <message>
        <source>Fewest neighbours (ror)</source>
        <translation>最少邻点数 (ror)</translation>
    </message>
    <message>
        <source>Fewest points</source>
        <translation>最少点数</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>滤波</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最大高度</translation>
    </message>
    <message>
        <source>How outliers are found before filtering: by the mean distance to the nearest neighbours (sor), by the number of neighbours within the radius (ror).</source>
        <translation>滤波前如何查找离群点：按到最近邻点的平均距离 (sor)，或按半径内的邻点数 (ror)。</translation>
    </message>
    <message>
        <source>Its mean distance to its nearest neighbours, or the number of neighbours within a radius.</source>
        <translation>到最近邻点的平均距离，或半径内邻点的数量。</translation>
    </message>
    <message>
        <source>Judge a point by</source>
        <translation>判断点的依据</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大尺寸</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>Limit (sor)</source>
        <translation>界限 (sor)</translation>
    </message>
    <message>
        <source>Nearest neighbours</source>
        <translation>最近邻点数</translation>
    </message>
    <message>
        <source>Nearest neighbours whose mean distance judges a point.</source>
        <translation>用多少个最近邻点的平均距离来判断一个点。</translation>
    </message>
    <message>
        <source>Neighbours (sor)</source>
        <translation>邻点数 (sor)</translation>
    </message>
    <message>
        <source>Neighbours of the filter and of radius outliers lie within this distance; automatic: 3 times the median spacing of the points.</source>
        <translation>滤波和半径离群点的邻点位于此距离之内；自动：点间距中位数的 3 倍。</translation>
    </message>
    <message>
        <source>Of the layers</source>
        <translation>图层范围</translation>
    </message>
    <message>
        <source>Only what lies at most this far behind the nearest surface under the outline is taken; none: however deep, and what is taken without being seen is counted.</source>
        <translation>只取轮廓下最近表面之后不超过此距离的部分；不填：不限深度，并统计未被看到而选中的点数。</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>离群点</translation>
    </message>
    <message>
        <source>Point of a voxel</source>
        <translation>体素的代表点</translation>
    </message>
    <message>
        <source>Points higher above the ground are passed over: crowns of trees, wires.</source>
        <translation>离地面高于此值的点略过：树冠、电线。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the neighbourhood</source>
        <translation>邻域半径</translation>
    </message>
    <message>
        <source>Rise over run that the ground may have from one bend to the next.</source>
        <translation>地面从一处转折到下一处允许的坡度（高差与水平距离之比）。</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>倍标准差</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小尺寸</translation>
    </message>
    <message>
        <source>Statistic of its neighbours that replaces each point's position.</source>
        <translation>用邻点的哪种统计量代替每个点的位置。</translation>
    </message>
    <message>
        <source>Steepest ground</source>
        <translation>最大地面坡度</translation>
    </message>
    <message>
        <source>Take what lies</source>
        <translation>所取部分</translation>
    </message>
    <message>
        <source>The points within the outline, or all others that are seen.</source>
        <translation>轮廓之内的点，或所见的其余各点。</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>允差</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>体素尺寸</translation>
    </message>
    <message>
        <source>What stands for a voxel: the centroid of its points, attributes averaged, or the measured point nearest to it.</source>
        <translation>用什么代表一个体素：其中各点的质心（属性取平均），或离质心最近的测量点。</translation>
    </message>
    <message>
        <source>What stands on the ground and is narrower than this is no ground.</source>
        <translation>立在地面上且比此值窄的物体不算地面。</translation>
    </message>
    <message>
        <source>Widest thing</source>
        <translation>最宽物体</translation>
    </message>
    <message>
        <source>a cell of %1 m is too small for a cloud of %2 by %3 m</source>
        <translation>%1 m 的单元对于 %2 m × %3 m 的点云过小</translation>
    </message>
    <message>
        <source>a unit of no length</source>
        <translation>长度单位无效</translation>
    </message>
    <message>
        <source>centroid</source>
        <translation>质心</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>expected 1e-9 to 1e9, or 0 for automatic</source>
        <translation>应为 1e-9 到 1e9，或 0 表示自动</translation>
    </message>
    <message>
        <source>expected a number above 0</source>
        <translation>应为大于 0 的数</translation>
    </message>
    <message>
        <source>expected a number from 0 up</source>
        <translation>应为不小于 0 的数</translation>
    </message>
    <message>
        <source>expected at most 2097149; a larger voxel is needed</source>
        <translation>应不超过 2097149；需要更大的体素</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>高斯</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>轮廓之内</translation>
    </message>
    <message>
        <source>lowest points</source>
        <translation>最低点</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>median</source>
        <translation>中值</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>最近点</translation>
    </message>
    <message>
        <source>neighbourhood radius: %1 m, 3 times the median spacing of the points</source>
        <translation>邻域半径：%1 m，为点间距中位数的 3 倍</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>number</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>outliers</source>
        <translation>离群点</translation>
    </message>
    <message>
        <source>outliers need a number of neighbours of at least 1</source>
        <translation>查找离群点至少需要 1 个邻点</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>轮廓之外</translation>
    </message>
    <message>
        <source>planes of the ground</source>
        <translation>地面的平面</translation>
    </message>
    <message>
        <source>ror</source>
        <translation>半径法 (ror)</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>所选图层</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>显示的图层</translation>
    </message>
    <message>
        <source>sor</source>
        <translation>统计法 (sor)</translation>
    </message>
    <message>
        <source>take a larger cell, or remove far strays first</source>
        <translation>请取较大的单元，或先移除远处的杂散点</translation>
    </message>
    <message>
        <source>the cloud is %1 long and has too many voxels of size %2 along one side</source>
        <translation>点云长 %1，沿一边尺寸为 %2 的体素过多</translation>
    </message>
    <message>
        <source>the coarsest voxel %1 is smaller than the finest %2</source>
        <translation>最粗体素 %1 小于最细体素 %2</translation>
    </message>
    <message>
        <source>the limit of %1 standard deviations is not allowed</source>
        <translation>不允许 %1 倍标准差的界限</translation>
    </message>
    <message>
        <source>the radius %1 cannot be searched</source>
        <translation>无法按半径 %1 搜索</translation>
    </message>
    <message>
        <source>the voxel size %1 is not a length</source>
        <translation>体素尺寸 %1 不是长度</translation>
    </message>
    <message>
        <source>there are no points to find the ground of</source>
        <translation>没有可供查找地面的点</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>what hangs together</source>
        <translation>相连的点</translation>
    </message>
    <message>
        <source>what stands above the ground</source>
        <translation>地面以上的物体</translation>
    </message>
    <message>
        <source>what stands on the ground</source>
        <translation>地面上的物体</translation>
    </message>
</context>
<context>
    <name>core/geometry</name>
    <message>
        <source>a number of the 4x4 pose is not finite</source>
        <translation>4x4 位姿中有一个数不是有限数</translation>
    </message>
    <message>
        <source>a scale belongs in its own field</source>
        <translation>比例应放在单独的字段中</translation>
    </message>
    <message>
        <source>expected 16 numbers, row by row</source>
        <translation>应为 16 个数，逐行排列</translation>
    </message>
    <message>
        <source>expected metres above 0, or no limit</source>
        <translation>应为大于 0 的米数，或不限</translation>
    </message>
    <message>
        <source>points within</source>
        <translation>范围内的点</translation>
    </message>
    <message>
        <source>the depth of a cut is not above 0 m</source>
        <translation>切取深度不大于 0 m</translation>
    </message>
    <message>
        <source>the last row of the 4x4 pose is not 0 0 0 1</source>
        <translation>4x4 位姿的最后一行不是 0 0 0 1</translation>
    </message>
    <message>
        <source>the rotation of the 4x4 pose is not orthonormal and right-handed</source>
        <translation>4x4 位姿的旋转不是右手正交的</translation>
    </message>
</context>
<context>
    <name>core/io</name>
    <message>
        <source>%1 (a list)</source>
        <translation>%1（列表）</translation>
    </message>
    <message>
        <source>%1 (and %2 of other tiles)</source>
        <translation>%1（另有其他瓦片的 %2）</translation>
    </message>
    <message>
        <source>%1 (byte %2 of %3, unpacked)</source>
        <translation>%1（解包后 %3 中的第 %2 字节）</translation>
    </message>
    <message>
        <source>%1 (record %2)</source>
        <translation>%1（记录 %2）</translation>
    </message>
    <message>
        <source>%1 after the end of the file's content passed over</source>
        <translation>略过文件内容结束之后的 %1</translation>
    </message>
    <message>
        <source>%1 after the end of the point tile passed over</source>
        <translation>略过点瓦片结束之后的 %1</translation>
    </message>
    <message>
        <source>%1 and one number</source>
        <translation>%1和一个数</translation>
    </message>
    <message>
        <source>%1 are whole and can be read where damage is allowed (--salvage; in a case &quot;salvage&quot;: true)</source>
        <translation>%1完好，在允许损坏之处可以读取（--salvage；在案件中为 &quot;salvage&quot;: true）</translation>
    </message>
    <message>
        <source>%1 as in POINTS</source>
        <translation>%1，与 POINTS 相同</translation>
    </message>
    <message>
        <source>%1 as in the rows above</source>
        <translation>%1，与上面各行相同</translation>
    </message>
    <message>
        <source>%1 as line %2 names</source>
        <translation>%1，如第 %2 行所列</translation>
    </message>
    <message>
        <source>%1 as the header says</source>
        <translation>%1，与文件头所述相同</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>%1 attribute</source>
        <translation>%1 个属性</translation>
    </message>
    <message>
        <source>%1 attributes</source>
        <translation>%1 个属性</translation>
    </message>
    <message>
        <source>%1 byte</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1 byte stream</source>
        <translation>%1 个字节流</translation>
    </message>
    <message>
        <source>%1 byte streams</source>
        <translation>%1 个字节流</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1 bytes are left</source>
        <translation>剩余 %1 字节</translation>
    </message>
    <message>
        <source>%1 bytes or more for each, %2 are left</source>
        <translation>每个 %1 字节或更多，剩余 %2</translation>
    </message>
    <message>
        <source>%1 bytes, as its header says</source>
        <translation>%1 字节，与其文件头所述相同</translation>
    </message>
    <message>
        <source>%1 chunk</source>
        <translation>%1 个块</translation>
    </message>
    <message>
        <source>%1 chunks</source>
        <translation>%1 个块</translation>
    </message>
    <message>
        <source>%1 coarser tile</source>
        <translation>%1 个较粗的瓦片</translation>
    </message>
    <message>
        <source>%1 coarser tiles</source>
        <translation>%1 个较粗的瓦片</translation>
    </message>
    <message>
        <source>%1 column</source>
        <translation>%1 列</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 列</translation>
    </message>
    <message>
        <source>%1 component</source>
        <translation>%1 个分量</translation>
    </message>
    <message>
        <source>%1 components</source>
        <translation>%1 个分量</translation>
    </message>
    <message>
        <source>%1 does not say how many points it has</source>
        <translation>%1 没有说明有多少个点</translation>
    </message>
    <message>
        <source>%1 does not say where it is</source>
        <translation>%1 没有说明其位置</translation>
    </message>
    <message>
        <source>%1 does not say where it lies</source>
        <translation>%1 没有说明位于何处</translation>
    </message>
    <message>
        <source>%1 extended record</source>
        <translation>%1 个扩展记录</translation>
    </message>
    <message>
        <source>%1 extended records</source>
        <translation>%1 个扩展记录</translation>
    </message>
    <message>
        <source>%1 face</source>
        <translation>%1 个面</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 个面</translation>
    </message>
    <message>
        <source>%1 facet</source>
        <translation>%1 个面片</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 个面片</translation>
    </message>
    <message>
        <source>%1 finer tile</source>
        <translation>%1 个更精细的瓦片</translation>
    </message>
    <message>
        <source>%1 finer tiles</source>
        <translation>%1 个更精细的瓦片</translation>
    </message>
    <message>
        <source>%1 finite number</source>
        <translation>%1 个有限数</translation>
    </message>
    <message>
        <source>%1 finite numbers</source>
        <translation>%1 个有限数</translation>
    </message>
    <message>
        <source>%1 for point format %2</source>
        <translation>点格式 %2 为 %1</translation>
    </message>
    <message>
        <source>%1 has no attributes</source>
        <translation>%1 没有属性</translation>
    </message>
    <message>
        <source>%1 has no points</source>
        <translation>%1 没有点</translation>
    </message>
    <message>
        <source>%1 has no primitives</source>
        <translation>%1 没有图元</translation>
    </message>
    <message>
        <source>%1 has the mode %2</source>
        <translation>%1 的模式为 %2</translation>
    </message>
    <message>
        <source>%1 image</source>
        <translation>%1 个图像</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 个图像</translation>
    </message>
    <message>
        <source>%1 is compressed by KHR_draco_mesh_compression, which is not read here</source>
        <translation>%1 用 KHR_draco_mesh_compression 压缩，此处不读取</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 不是数</translation>
    </message>
    <message>
        <source>%1 is no vector</source>
        <translation>%1 不是向量</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 不是有限数</translation>
    </message>
    <message>
        <source>%1 is packed by a codec that is unknown</source>
        <translation>%1 用未知的编解码器打包</translation>
    </message>
    <message>
        <source>%1 is said to begin at byte %2, inside a page's checksum</source>
        <translation>%1 据称从第 %2 字节开始，该处位于页的校验和之内</translation>
    </message>
    <message>
        <source>%1 is said to begin at byte %2, outside of the file</source>
        <translation>%1 据称从第 %2 字节开始，该处位于文件之外</translation>
    </message>
    <message>
        <source>%1 item</source>
        <translation>%1 项</translation>
    </message>
    <message>
        <source>%1 items</source>
        <translation>%1 项</translation>
    </message>
    <message>
        <source>%1 items inside the view's %2 bytes</source>
        <translation>%1 项，位于视图的 %2 字节之内</translation>
    </message>
    <message>
        <source>%1 items, counted from 0</source>
        <translation>%1 项，从 0 起计</translation>
    </message>
    <message>
        <source>%1 left out, since finer ones replace them</source>
        <translation>略去 %1，由更精细的瓦片代替</translation>
    </message>
    <message>
        <source>%1 marked as withheld, read all the same</source>
        <translation>%1标记为保留点，仍予读取</translation>
    </message>
    <message>
        <source>%1 mesh</source>
        <translation>%1 个网格</translation>
    </message>
    <message>
        <source>%1 meshs</source>
        <translation>%1 个网格</translation>
    </message>
    <message>
        <source>%1 names item %2 of '%3'</source>
        <translation>%1 指定了“%3”的第 %2 项</translation>
    </message>
    <message>
        <source>%1 needs %2 of %3 from offset %4 on, its section has %5</source>
        <translation>%1 从偏移 %4 起需要 %3 的 %2，其分区有 %5</translation>
    </message>
    <message>
        <source>%1 node</source>
        <translation>%1 个节点</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 个节点</translation>
    </message>
    <message>
        <source>%1 not read; open the index (*.scp) for the whole cloud</source>
        <translation>%1未读取；要读取整个点云请打开索引 (*.scp)</translation>
    </message>
    <message>
        <source>%1 number</source>
        <translation>%1 个数</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 个数</translation>
    </message>
    <message>
        <source>%1 numbers on each line</source>
        <translation>每行 %1 个数</translation>
    </message>
    <message>
        <source>%1 of %2 are damaged, the first at byte %3</source>
        <translation>%2中有 %1 损坏，第一处在第 %3 字节</translation>
    </message>
    <message>
        <source>%1 of %2 is damaged, the first at byte %3</source>
        <translation>%2中有 %1 损坏，第一处在第 %3 字节</translation>
    </message>
    <message>
        <source>%1 of %2 is no finite number</source>
        <translation>%2 的 %1 不是有限数</translation>
    </message>
    <message>
        <source>%1 of %2 is no integer</source>
        <translation>%2 的 %1 不是整数</translation>
    </message>
    <message>
        <source>%1 of JSON</source>
        <translation>%1 的 JSON</translation>
    </message>
    <message>
        <source>%1 of lines or surfaces passed over</source>
        <translation>略过线或面的 %1</translation>
    </message>
    <message>
        <source>%1 of objects without colours are white</source>
        <translation>没有颜色的对象的 %1 取为白色</translation>
    </message>
    <message>
        <source>%1 of the kind %2 passed over; only point tiles are read</source>
        <translation>略过 %2 类的 %1；只读取点瓦片</translation>
    </message>
    <message>
        <source>%1 of the source not written</source>
        <translation>源的 %1 未写出</translation>
    </message>
    <message>
        <source>%1 of the tiles could not be read whole, their points are missing (%2 named): %3</source>
        <translation>%1未能完整读取，缺少其中的点（列出 %2 个）：%3</translation>
    </message>
    <message>
        <source>%1 of the tiles could not be read, their points are missing: %2</source>
        <translation>%1未能读取，缺少其中的点：%2</translation>
    </message>
    <message>
        <source>%1 of unknown meaning not kept</source>
        <translation>含义不明的 %1 未保留</translation>
    </message>
    <message>
        <source>%1 or more for point format %2</source>
        <translation>点格式 %2 为 %1 或更多</translation>
    </message>
    <message>
        <source>%1 or more, and no more than the file has</source>
        <translation>%1 或更多，且不多于文件所有</translation>
    </message>
    <message>
        <source>%1 page</source>
        <translation>%1 页</translation>
    </message>
    <message>
        <source>%1 pages</source>
        <translation>%1 页</translation>
    </message>
    <message>
        <source>%1 part</source>
        <translation>%1 部分</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 部分</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>%1 points as its counts say</source>
        <translation>%1 个点，与其计数所述相同</translation>
    </message>
    <message>
        <source>%1 points as its header says</source>
        <translation>%1 个点，与其文件头所述相同</translation>
    </message>
    <message>
        <source>%1 points as the header says</source>
        <translation>%1 个点，与文件头所述相同</translation>
    </message>
    <message>
        <source>%1 points need %2 of memory, %3 are free</source>
        <translation>%1 个点需要 %2 内存，可用 %3</translation>
    </message>
    <message>
        <source>%1 points of %2 bytes</source>
        <translation>%1 个 %2 字节的点</translation>
    </message>
    <message>
        <source>%1 primitives</source>
        <translation>%1 个图元</translation>
    </message>
    <message>
        <source>%1 record</source>
        <translation>%1 条记录</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 条记录</translation>
    </message>
    <message>
        <source>%1 row</source>
        <translation>%1 行</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 行</translation>
    </message>
    <message>
        <source>%1 scan</source>
        <translation>%1 个扫描</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 个扫描</translation>
    </message>
    <message>
        <source>%1 scans at most</source>
        <translation>至多 %1 个扫描</translation>
    </message>
    <message>
        <source>%1 tile</source>
        <translation>%1 个瓦片</translation>
    </message>
    <message>
        <source>%1 tiles</source>
        <translation>%1 个瓦片</translation>
    </message>
    <message>
        <source>%1 triangle</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 个值</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 个值</translation>
    </message>
    <message>
        <source>%1 vertex</source>
        <translation>%1 个顶点</translation>
    </message>
    <message>
        <source>%1 vertexs</source>
        <translation>%1 个顶点</translation>
    </message>
    <message>
        <source>%1 with fewer than three corners left out</source>
        <translation>略去少于三个角点的 %1</translation>
    </message>
    <message>
        <source>%1 with more values than columns, the rest not kept</source>
        <translation>%1的值多于列数，多余者未保留</translation>
    </message>
    <message>
        <source>%1 with more values than x y z i r g b, the rest not kept</source>
        <translation>%1的值多于 x y z i r g b，多余者未保留</translation>
    </message>
    <message>
        <source>%1 with two equal corners left out</source>
        <translation>略去有两个相同角点的 %1</translation>
    </message>
    <message>
        <source>%1 without a position left out: the scanner got no echo there</source>
        <translation>略去没有位置的 %1：扫描仪在该处没有收到回波</translation>
    </message>
    <message>
        <source>%1 without a return left out</source>
        <translation>略去没有回波的 %1</translation>
    </message>
    <message>
        <source>%1 without finite coordinates left out</source>
        <translation>略去坐标不是有限数的 %1</translation>
    </message>
    <message>
        <source>%1, as many as the prototype has fields</source>
        <translation>%1，与原型的字段数相同</translation>
    </message>
    <message>
        <source>%1, ascii</source>
        <translation>%1，ASCII</translation>
    </message>
    <message>
        <source>%1, binary</source>
        <translation>%1，二进制</translation>
    </message>
    <message>
        <source>%1, binary_compressed</source>
        <translation>%1，压缩二进制</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1，第 %2 字节</translation>
    </message>
    <message>
        <source>%1, byte 0</source>
        <translation>%1，第 0 字节</translation>
    </message>
    <message>
        <source>%1, counted from 0</source>
        <translation>%1，从 0 起计</translation>
    </message>
    <message>
        <source>%1, heights above the ellipsoid</source>
        <translation>%1，椭球高</translation>
    </message>
    <message>
        <source>%1, heights above the ellipsoid; latitude %2, longitude %3 degrees</source>
        <translation>%1，椭球高；纬度 %2 度，经度 %3 度</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1, one for each vertex</source>
        <translation>%1，每个顶点一个</translation>
    </message>
    <message>
        <source>%1; all points could be read</source>
        <translation>%1；所有点均能读取</translation>
    </message>
    <message>
        <source>%1; otherwise export the cloud as LAS or 3D Tiles (PNTS)</source>
        <translation>%1；否则请将点云导出为 LAS 或 3D Tiles (PNTS)</translation>
    </message>
    <message>
        <source>'%1' does not fit what the archive's directory says</source>
        <translation>“%1”与压缩包目录所述不符</translation>
    </message>
    <message>
        <source>'%1' in the archive is encrypted or packed in a rare way</source>
        <translation>压缩包中的“%1”已加密或以罕见方式打包</translation>
    </message>
    <message>
        <source>'%1' is no keyword of a PLY header</source>
        <translation>“%1”不是 PLY 文件头的关键字</translation>
    </message>
    <message>
        <source>'%1' is no type of a PLY property</source>
        <translation>“%1”不是 PLY 属性的类型</translation>
    </message>
    <message>
        <source>'%1' is not where the archive says</source>
        <translation>“%1”不在压缩包所述之处</translation>
    </message>
    <message>
        <source>'%1' of the glTF document is missing or of a wrong type</source>
        <translation>glTF 文档的“%1”缺失或类型错误</translation>
    </message>
    <message>
        <source>'asset' with the version &quot;2.0&quot;</source>
        <translation>版本为 &quot;2.0&quot; 的“asset”</translation>
    </message>
    <message>
        <source>'indices' and 'values', no more than the accessor has items</source>
        <translation>“indices”和“values”，不多于访问器的项数</translation>
    </message>
    <message>
        <source>0 (none) or 1 (Draco)</source>
        <translation>0（无）或 1（Draco）</translation>
    </message>
    <message>
        <source>0 (not), 1 (zip) or 2 (gzip)</source>
        <translation>0（未压缩）、1（zip）或 2（gzip）</translation>
    </message>
    <message>
        <source>0 0 0 1 as its last column, the shift in its last row</source>
        <translation>最后一列为 0 0 0 1，平移在最后一行</translation>
    </message>
    <message>
        <source>0 to 3, of 1 to 64 numbers</source>
        <translation>0 到 3，含 1 到 64 个数</translation>
    </message>
    <message>
        <source>1, 2 or 3, and coder 0</source>
        <translation>1、2 或 3，且编码器为 0</translation>
    </message>
    <message>
        <source>1.%1, point format %2</source>
        <translation>1.%1，点格式 %2</translation>
    </message>
    <message>
        <source>1.0, binary big endian</source>
        <translation>1.0，大端二进制</translation>
    </message>
    <message>
        <source>1.0, binary little endian</source>
        <translation>1.0，小端二进制</translation>
    </message>
    <message>
        <source>12 bytes and a JSON chunk</source>
        <translation>12 字节和一个 JSON 块</translation>
    </message>
    <message>
        <source>16 levels at most</source>
        <translation>至多 16 层</translation>
    </message>
    <message>
        <source>16 numbers, column after column</source>
        <translation>16 个数，逐列排列</translation>
    </message>
    <message>
        <source>227 bytes of header or more</source>
        <translation>227 字节或更多的文件头</translation>
    </message>
    <message>
        <source>3D Tiles point tile</source>
        <translation>3D Tiles 点瓦片</translation>
    </message>
    <message>
        <source>3D Tiles tileset</source>
        <translation>3D Tiles 瓦片集</translation>
    </message>
    <message>
        <source>3MF mesh</source>
        <translation>3MF 网格</translation>
    </message>
    <message>
        <source>50 bytes for each, %1 are left</source>
        <translation>每个 50 字节，剩余 %1</translation>
    </message>
    <message>
        <source>8 bytes or more</source>
        <translation>8 字节或更多</translation>
    </message>
    <message>
        <source>ADD or REPLACE</source>
        <translation>ADD 或 REPLACE</translation>
    </message>
    <message>
        <source>ASCII or BINARY</source>
        <translation>ASCII 或 BINARY</translation>
    </message>
    <message>
        <source>Add or Replace</source>
        <translation>Add 或 Replace</translation>
    </message>
    <message>
        <source>Assimp reads %1 of the file</source>
        <translation>Assimp 读取了文件的 %1</translation>
    </message>
    <message>
        <source>BATCH_ID has no whole numbers</source>
        <translation>BATCH_ID 没有整数</translation>
    </message>
    <message>
        <source>CONNECTIVITY is missing</source>
        <translation>缺少 CONNECTIVITY</translation>
    </message>
    <message>
        <source>CONSTANT_RGBA has a channel that is none</source>
        <translation>CONSTANT_RGBA 有一个无效的通道</translation>
    </message>
    <message>
        <source>COPC of %1</source>
        <translation>COPC，%1</translation>
    </message>
    <message>
        <source>Degree or Meter</source>
        <translation>Degree 或 Meter</translation>
    </message>
    <message>
        <source>E57 holds no surfaces: %1 left out, their corners are written as points</source>
        <translation>E57 不含表面：略去 %1，其角点作为点写出</translation>
    </message>
    <message>
        <source>E57 laser scans</source>
        <translation>E57 激光扫描</translation>
    </message>
    <message>
        <source>EPSG:4978 (ECEF, WGS 84), as the tileset's regions say</source>
        <translation>EPSG:4978（地心地固，WGS 84），依瓦片集的区域所述</translation>
    </message>
    <message>
        <source>EinScan marker file</source>
        <translation>EinScan 标志点文件</translation>
    </message>
    <message>
        <source>FIELDS, SIZE, TYPE and COUNT have different numbers of entries</source>
        <translation>FIELDS、SIZE、TYPE 和 COUNT 的项数不同</translation>
    </message>
    <message>
        <source>I or U of 1, 2, 4, 8 bytes, F of 4, 8</source>
        <translation>1、2、4、8 字节的 I 或 U，4、8 字节的 F</translation>
    </message>
    <message>
        <source>Integer, ScaledInteger, Float or String</source>
        <translation>Integer、ScaledInteger、Float 或 String</translation>
    </message>
    <message>
        <source>JSON in UTF-8</source>
        <translation>UTF-8 编码的 JSON</translation>
    </message>
    <message>
        <source>LAS point cloud</source>
        <translation>LAS 点云</translation>
    </message>
    <message>
        <source>LAS version %1.%2 is unknown</source>
        <translation>LAS 版本 %1.%2 未知</translation>
    </message>
    <message>
        <source>LASzip cannot be started</source>
        <translation>LASzip 无法启动</translation>
    </message>
    <message>
        <source>LASzip cannot pack the points: %1</source>
        <translation>LASzip 无法压缩这些点：%1</translation>
    </message>
    <message>
        <source>LASzip's record does not describe points of this format</source>
        <translation>LASzip 记录所述的不是此格式的点</translation>
    </message>
    <message>
        <source>LASzip's record has %1</source>
        <translation>LASzip 记录有 %1</translation>
    </message>
    <message>
        <source>LASzip's record names an unknown compressor</source>
        <translation>LASzip 记录指定了未知的压缩器</translation>
    </message>
    <message>
        <source>LASzip's record names chunks of no points</source>
        <translation>LASzip 记录指定了没有点的块</translation>
    </message>
    <message>
        <source>LZF data</source>
        <translation>LZF 数据</translation>
    </message>
    <message>
        <source>PCD point cloud</source>
        <translation>PCD 点云</translation>
    </message>
    <message>
        <source>PLY point cloud or mesh</source>
        <translation>PLY 点云或网格</translation>
    </message>
    <message>
        <source>POINTS, POLYGONS, POINT_DATA and such</source>
        <translation>POINTS、POLYGONS、POINT_DATA 等</translation>
    </message>
    <message>
        <source>POINTS, or WIDTH and HEIGHT</source>
        <translation>POINTS，或 WIDTH 和 HEIGHT</translation>
    </message>
    <message>
        <source>POINT_DATA is for %1 points</source>
        <translation>POINT_DATA 针对 %1 个点</translation>
    </message>
    <message>
        <source>POSITION or POSITION_QUANTIZED</source>
        <translation>POSITION 或 POSITION_QUANTIZED</translation>
    </message>
    <message>
        <source>PTX scans</source>
        <translation>PTX 扫描</translation>
    </message>
    <message>
        <source>QUANTIZED_VOLUME_OFFSET and QUANTIZED_VOLUME_SCALE</source>
        <translation>QUANTIZED_VOLUME_OFFSET 和 QUANTIZED_VOLUME_SCALE</translation>
    </message>
    <message>
        <source>S3M is read by SuperMap's specification alone; compare with an export as LAS or 3D Tiles</source>
        <translation>S3M 仅按 SuperMap 的规范读取；请与导出的 LAS 或 3D Tiles 比较</translation>
    </message>
    <message>
        <source>SBET trajectory</source>
        <translation>SBET 轨迹</translation>
    </message>
    <message>
        <source>STL mesh</source>
        <translation>STL 网格</translation>
    </message>
    <message>
        <source>SuperMap S3M point cloud</source>
        <translation>SuperMap S3M 点云</translation>
    </message>
    <message>
        <source>Text with one point a line</source>
        <translation>每行一个点的文本</translation>
    </message>
    <message>
        <source>VEC3 of the component type 5126</source>
        <translation>组件类型 5126 的 VEC3</translation>
    </message>
    <message>
        <source>VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or DATA</source>
        <translation>VERSION、FIELDS、SIZE、TYPE、COUNT、WIDTH、HEIGHT、VIEWPOINT、POINTS 或 DATA</translation>
    </message>
    <message>
        <source>VIEWPOINT is not applied to the points</source>
        <translation>VIEWPOINT 未应用于各点</translation>
    </message>
    <message>
        <source>VTK legacy point data</source>
        <translation>VTK 旧式点数据</translation>
    </message>
    <message>
        <source>WGS 84 / UTM zone %1N</source>
        <translation>WGS 84 / UTM %1N 带</translation>
    </message>
    <message>
        <source>WGS 84 / UTM zone %1S</source>
        <translation>WGS 84 / UTM %1S 带</translation>
    </message>
    <message>
        <source>WIDTH times HEIGHT is too large</source>
        <translation>WIDTH 与 HEIGHT 的乘积过大</translation>
    </message>
    <message>
        <source>Wavefront OBJ mesh</source>
        <translation>Wavefront OBJ 网格</translation>
    </message>
    <message>
        <source>a Blob section</source>
        <translation>Blob 分区</translation>
    </message>
    <message>
        <source>a CompressedVector section (1)</source>
        <translation>CompressedVector 分区 (1)</translation>
    </message>
    <message>
        <source>a PTX header</source>
        <translation>PTX 文件头</translation>
    </message>
    <message>
        <source>a block of a wrong length</source>
        <translation>长度错误的数据块</translation>
    </message>
    <message>
        <source>a block of an unknown kind</source>
        <translation>类型未知的数据块</translation>
    </message>
    <message>
        <source>a buffer inside the document is not in base64</source>
        <translation>文档中的缓冲区不是 base64 编码</translation>
    </message>
    <message>
        <source>a buffer view</source>
        <translation>缓冲区视图</translation>
    </message>
    <message>
        <source>a byte of its content</source>
        <translation>其内容中的某个字节</translation>
    </message>
    <message>
        <source>a byte within it</source>
        <translation>其中的某个字节</translation>
    </message>
    <message>
        <source>a cell is longer than its section</source>
        <translation>某个单元长于其分区</translation>
    </message>
    <message>
        <source>a chunk JSON, then BIN</source>
        <translation>先 JSON 块，再 BIN 块</translation>
    </message>
    <message>
        <source>a chunk of compressed points does not fit into the file, or holds what no encoder writes</source>
        <translation>压缩点的某个块与文件不符，或含有任何编码器都不会写出的内容</translation>
    </message>
    <message>
        <source>a chunk of points that is whole</source>
        <translation>完整的点块</translation>
    </message>
    <message>
        <source>a chunk promises more bytes than the file has</source>
        <translation>某个块承诺的字节多于文件所有</translation>
    </message>
    <message>
        <source>a chunk size such as 50000</source>
        <translation>块的大小，例如 50000</translation>
    </message>
    <message>
        <source>a componentType such as FLOAT, and SCALAR or VEC2 to VEC4</source>
        <translation>componentType（例如 FLOAT），以及 SCALAR 或 VEC2 到 VEC4</translation>
    </message>
    <message>
        <source>a compressed file without a whole record of LASzip</source>
        <translation>没有完整 LASzip 记录的压缩文件</translation>
    </message>
    <message>
        <source>a compressed skeleton</source>
        <translation>压缩的骨架</translation>
    </message>
    <message>
        <source>a coordinate is missing or no number</source>
        <translation>缺少坐标，或坐标不是数</translation>
    </message>
    <message>
        <source>a coordinate is no finite number</source>
        <translation>坐标不是有限数</translation>
    </message>
    <message>
        <source>a coordinate is no finite number, or farther from 0 than any place on Earth</source>
        <translation>坐标不是有限数，或到 0 的距离超过地球上任何地点</translation>
    </message>
    <message>
        <source>a count is missing or no whole number</source>
        <translation>缺少计数，或计数不是整数</translation>
    </message>
    <message>
        <source>a count of %1 is more than the file can hold</source>
        <translation>计数 %1 多于文件所能容纳</translation>
    </message>
    <message>
        <source>a decimal number</source>
        <translation>十进制数</translation>
    </message>
    <message>
        <source>a face has %1 corners</source>
        <translation>某个面有 %1 个角点</translation>
    </message>
    <message>
        <source>a face names a vertex or normal that is not there</source>
        <translation>某个面指定了不存在的顶点或法向量</translation>
    </message>
    <message>
        <source>a face names vertex %1</source>
        <translation>某个面指定了顶点 %1</translation>
    </message>
    <message>
        <source>a facet ends without three vertices</source>
        <translation>某个三角面片结束时没有三个顶点</translation>
    </message>
    <message>
        <source>a field of %1 holds text</source>
        <translation>%1 的某个字段含有文本</translation>
    </message>
    <message>
        <source>a field of the prototype is of a type that records cannot have</source>
        <translation>原型的某个字段的类型是记录不能有的</translation>
    </message>
    <message>
        <source>a file beside the document</source>
        <translation>文档旁边的文件</translation>
    </message>
    <message>
        <source>a file in memory cannot be made</source>
        <translation>无法在内存中创建文件</translation>
    </message>
    <message>
        <source>a file in memory cannot be written</source>
        <translation>无法写入内存中的文件</translation>
    </message>
    <message>
        <source>a file in the archive has a name that leads out of it</source>
        <translation>压缩包中某个文件的名称指向包外</translation>
    </message>
    <message>
        <source>a file in the document's own folder</source>
        <translation>文档所在文件夹中的文件</translation>
    </message>
    <message>
        <source>a file that is whole</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>a file that its reader is done with in that time</source>
        <translation>其读取器能在此时间内读完的文件</translation>
    </message>
    <message>
        <source>a file that nobody changes meanwhile</source>
        <translation>期间无人更改的文件</translation>
    </message>
    <message>
        <source>a file without it; most programs can export one</source>
        <translation>不含该扩展的文件；多数程序可以导出</translation>
    </message>
    <message>
        <source>a file, not a folder or device</source>
        <translation>文件，而不是文件夹或设备</translation>
    </message>
    <message>
        <source>a glTF document in JSON</source>
        <translation>JSON 格式的 glTF 文档</translation>
    </message>
    <message>
        <source>a header of 48 bytes</source>
        <translation>48 字节的文件头</translation>
    </message>
    <message>
        <source>a length from 0 to what the file still holds</source>
        <translation>从 0 到文件剩余量的长度</translation>
    </message>
    <message>
        <source>a length of %1 is no number of whole pages</source>
        <translation>长度 %1 不是整数页</translation>
    </message>
    <message>
        <source>a length within it</source>
        <translation>其内的长度</translation>
    </message>
    <message>
        <source>a line 'DATA ascii|binary|binary_compressed'</source>
        <translation>一行“DATA ascii|binary|binary_compressed”</translation>
    </message>
    <message>
        <source>a line 'element' before it</source>
        <translation>在其之前应有一行“element”</translation>
    </message>
    <message>
        <source>a line 'end_header'</source>
        <translation>一行“end_header”</translation>
    </message>
    <message>
        <source>a line 'endsolid'</source>
        <translation>一行“endsolid”</translation>
    </message>
    <message>
        <source>a line 'format ascii|binary_... 1.0'</source>
        <translation>一行“format ascii|binary_... 1.0”</translation>
    </message>
    <message>
        <source>a line 'property'</source>
        <translation>一行“property”</translation>
    </message>
    <message>
        <source>a line 'solid', or 84 bytes of header</source>
        <translation>一行“solid”，或 84 字节的文件头</translation>
    </message>
    <message>
        <source>a line POINTS</source>
        <translation>一行 POINTS</translation>
    </message>
    <message>
        <source>a list of objects</source>
        <translation>对象的列表</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>文本的列表</translation>
    </message>
    <message>
        <source>a list of them</source>
        <translation>它们的列表</translation>
    </message>
    <message>
        <source>a list of whole numbers</source>
        <translation>整数的列表</translation>
    </message>
    <message>
        <source>a list of whole numbers from 0</source>
        <translation>从 0 起的整数的列表</translation>
    </message>
    <message>
        <source>a list's length does not fit the file</source>
        <translation>列表的长度与文件不符</translation>
    </message>
    <message>
        <source>a list's length is no integer</source>
        <translation>列表的长度不是整数</translation>
    </message>
    <message>
        <source>a matrix whose last row is 0 0 0 1</source>
        <translation>最后一行为 0 0 0 1 的矩阵</translation>
    </message>
    <message>
        <source>a mesh without vertices</source>
        <translation>没有顶点的网格</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>%1 的倍数</translation>
    </message>
    <message>
        <source>a multiple of 4, %1 at most</source>
        <translation>4 的倍数，至多 %1</translation>
    </message>
    <message>
        <source>a number is too large to be held</source>
        <translation>某个数太大，无法容纳</translation>
    </message>
    <message>
        <source>a number of pixels</source>
        <translation>像素数</translation>
    </message>
    <message>
        <source>a number of the JSON is too large</source>
        <translation>JSON 中的某个数太大</translation>
    </message>
    <message>
        <source>a number type and 1 to 4 components</source>
        <translation>数值类型和 1 到 4 个分量</translation>
    </message>
    <message>
        <source>a packed part is damaged: it unpacks to %1</source>
        <translation>打包的部分已损坏：解包得到 %1</translation>
    </message>
    <message>
        <source>a packed part of %1 promises to unpack to %2</source>
        <translation>%1的打包部分承诺解包为 %2</translation>
    </message>
    <message>
        <source>a packet has %1</source>
        <translation>某个数据包有 %1</translation>
    </message>
    <message>
        <source>a packet is damaged</source>
        <translation>某个数据包已损坏</translation>
    </message>
    <message>
        <source>a packet is too short for its table</source>
        <translation>某个数据包太短，容不下其表</translation>
    </message>
    <message>
        <source>a packet of %1 does not fit into its section</source>
        <translation>%1的数据包与其分区不符</translation>
    </message>
    <message>
        <source>a packet of unknown kind %1</source>
        <translation>未知类型 %1 的数据包</translation>
    </message>
    <message>
        <source>a place behind the header and inside the file of %1 bytes</source>
        <translation>文件头之后、%1 字节的文件之内的位置</translation>
    </message>
    <message>
        <source>a place behind the points and inside the file</source>
        <translation>各点之后、文件之内的位置</translation>
    </message>
    <message>
        <source>a point cloud</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>a point cloud, a mesh or a tileset</source>
        <translation>点云、网格或瓦片集</translation>
    </message>
    <message>
        <source>a point is said to have %1</source>
        <translation>据称每个点有 %1</translation>
    </message>
    <message>
        <source>a polygon names a point that is not there</source>
        <translation>某个多边形指定了不存在的点</translation>
    </message>
    <message>
        <source>a position for each vertex</source>
        <translation>每个顶点的位置</translation>
    </message>
    <message>
        <source>a primitive without a whole triangle is left out</source>
        <translation>略去没有完整三角形的图元</translation>
    </message>
    <message>
        <source>a primitive without positions is left out</source>
        <translation>略去没有位置的图元</translation>
    </message>
    <message>
        <source>a quaternion of unit length</source>
        <translation>单位长度的四元数</translation>
    </message>
    <message>
        <source>a row of the transform</source>
        <translation>变换的一行</translation>
    </message>
    <message>
        <source>a scale factor is zero, no finite number or absurd</source>
        <translation>比例因子为零、不是有限数或不合理</translation>
    </message>
    <message>
        <source>a scale such as 0.001</source>
        <translation>例如 0.001 的比例</translation>
    </message>
    <message>
        <source>a scan is said to have %1 points, for which the file has no room</source>
        <translation>据称某个扫描有 %1 个点，文件容不下</translation>
    </message>
    <message>
        <source>a scan of %1 columns and %2 rows is promised, but the file has room for %3</source>
        <translation>承诺有 %1 列 %2 行的扫描，而文件只容得下 %3</translation>
    </message>
    <message>
        <source>a scene or node</source>
        <translation>场景或节点</translation>
    </message>
    <message>
        <source>a section for every scan</source>
        <translation>每个扫描各有一个分区</translation>
    </message>
    <message>
        <source>a section of %1 does not fit into the file</source>
        <translation>%1的分区与文件不符</translation>
    </message>
    <message>
        <source>a skeleton is compressed in the way %1</source>
        <translation>某个骨架以方式 %1 压缩</translation>
    </message>
    <message>
        <source>a sparse accessor of %1 is not whole</source>
        <translation>%1 的稀疏访问器不完整</translation>
    </message>
    <message>
        <source>a stored file of one size</source>
        <translation>大小唯一的存储文件</translation>
    </message>
    <message>
        <source>a trajectory within %1 degrees of longitude</source>
        <translation>经度在 %1 度之内的轨迹</translation>
    </message>
    <message>
        <source>a translation in the last four numbers</source>
        <translation>最后四个数为平移</translation>
    </message>
    <message>
        <source>a tree of nodes</source>
        <translation>节点树</translation>
    </message>
    <message>
        <source>a triangle names vertex %1 of a mesh</source>
        <translation>某个三角形指定了网格的顶点 %1</translation>
    </message>
    <message>
        <source>a value is missing or no number</source>
        <translation>缺少某个值，或它不是数</translation>
    </message>
    <message>
        <source>a value is no number</source>
        <translation>某个值不是数</translation>
    </message>
    <message>
        <source>a value is no whole number</source>
        <translation>某个值不是整数</translation>
    </message>
    <message>
        <source>a vertex of the file's %1</source>
        <translation>文件的 %1中的一个顶点</translation>
    </message>
    <message>
        <source>a vertex package</source>
        <translation>顶点包</translation>
    </message>
    <message>
        <source>a view inside the buffer's %1 bytes</source>
        <translation>在缓冲区的 %1 字节之内的视图</translation>
    </message>
    <message>
        <source>a whole LAZ file</source>
        <translation>完整的 LAZ 文件</translation>
    </message>
    <message>
        <source>a whole and valid file of this format</source>
        <translation>此格式的完整有效的文件</translation>
    </message>
    <message>
        <source>a whole feature table</source>
        <translation>完整的要素表</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>从 0 起的整数</translation>
    </message>
    <message>
        <source>a whole number from 0 on</source>
        <translation>从 0 起的整数</translation>
    </message>
    <message>
        <source>a whole number from 0 to 4294967295</source>
        <translation>0 到 4294967295 的整数</translation>
    </message>
    <message>
        <source>a whole one: it cannot be decoded in parts</source>
        <translation>完整的流：它不能分部分解码</translation>
    </message>
    <message>
        <source>a whole packet</source>
        <translation>完整的数据包</translation>
    </message>
    <message>
        <source>a whole stream</source>
        <translation>完整的流</translation>
    </message>
    <message>
        <source>a whole tile</source>
        <translation>完整的瓦片</translation>
    </message>
    <message>
        <source>a whole zip archive</source>
        <translation>完整的 zip 压缩包</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>zip 压缩包</translation>
    </message>
    <message>
        <source>a zlib or gzip stream of %1</source>
        <translation>解包为 %1的 zlib 或 gzip 流</translation>
    </message>
    <message>
        <source>accessor %1 of %2 holds '%3' of the component type %4</source>
        <translation>%2 的访问器 %1 含有组件类型 %4 的“%3”</translation>
    </message>
    <message>
        <source>accessor %1 of %2 names no buffer view</source>
        <translation>%2 的访问器 %1 没有指定缓冲区视图</translation>
    </message>
    <message>
        <source>accessor %1 of %2 promises %3 items</source>
        <translation>%2 的访问器 %1 承诺有 %3 项</translation>
    </message>
    <message>
        <source>accessors with a buffer view</source>
        <translation>有缓冲区视图的访问器</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>所有点</translation>
    </message>
    <message>
        <source>an accessor of %1 leaves buffer view %2</source>
        <translation>%1 的访问器超出缓冲区视图 %2</translation>
    </message>
    <message>
        <source>an affine transform, column after column</source>
        <translation>仿射变换，逐列排列</translation>
    </message>
    <message>
        <source>an array is larger than any file</source>
        <translation>某个数组大于任何文件</translation>
    </message>
    <message>
        <source>an array's type is unknown</source>
        <translation>数组的类型未知</translation>
    </message>
    <message>
        <source>an attribute for them</source>
        <translation>对应的属性</translation>
    </message>
    <message>
        <source>an attribute has the type %1</source>
        <translation>某个属性的类型为 %1</translation>
    </message>
    <message>
        <source>an element 'e57Root'</source>
        <translation>元素“e57Root”</translation>
    </message>
    <message>
        <source>an element 'points'</source>
        <translation>元素“points”</translation>
    </message>
    <message>
        <source>an element 'vertex'</source>
        <translation>元素“vertex”</translation>
    </message>
    <message>
        <source>an entry of the zip directory is broken</source>
        <translation>zip 目录的某个条目已损坏</translation>
    </message>
    <message>
        <source>an image cannot be of %1 pixels</source>
        <translation>图像不可能有 %1 像素</translation>
    </message>
    <message>
        <source>an image reaches beyond the file</source>
        <translation>某个图像超出文件</translation>
    </message>
    <message>
        <source>an index from 0 to %1 - 1</source>
        <translation>从 0 到 %1 - 1 的索引</translation>
    </message>
    <message>
        <source>an index package</source>
        <translation>索引包</translation>
    </message>
    <message>
        <source>an index, data or ignored packet (0, 1, 2)</source>
        <translation>索引、数据或忽略的数据包 (0、1、2)</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>an integer type</source>
        <translation>整数类型</translation>
    </message>
    <message>
        <source>an object names a mesh that is not there</source>
        <translation>某个对象指定了不存在的网格</translation>
    </message>
    <message>
        <source>an object that holds it</source>
        <translation>含有它的对象</translation>
    </message>
    <message>
        <source>an offset is no finite number, or farther from 0 than any place on Earth</source>
        <translation>偏移不是有限数，或到 0 的距离超过地球上任何地点</translation>
    </message>
    <message>
        <source>an offset of a cell is out of order</source>
        <translation>某个单元的偏移顺序错误</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>animations are left out</source>
        <translation>略去动画</translation>
    </message>
    <message>
        <source>arrays within their section</source>
        <translation>位于其分区之内的数组</translation>
    </message>
    <message>
        <source>as many as it has, %1</source>
        <translation>与其实有的 %1 相同</translation>
    </message>
    <message>
        <source>as many points as its XML promises</source>
        <translation>与其 XML 承诺的点数相同</translation>
    </message>
    <message>
        <source>as many values as announced</source>
        <translation>与所声明的值的个数相同</translation>
    </message>
    <message>
        <source>as many values as the header promises</source>
        <translation>与文件头承诺的值的个数相同</translation>
    </message>
    <message>
        <source>ascii, binary or binary_compressed</source>
        <translation>ascii、binary 或 binary_compressed</translation>
    </message>
    <message>
        <source>ascii, binary_little_endian or binary_big_endian</source>
        <translation>ascii、binary_little_endian 或 binary_big_endian</translation>
    </message>
    <message>
        <source>at least %1 bytes for each, %2 are left</source>
        <translation>每个至少 %1 字节，剩余 %2</translation>
    </message>
    <message>
        <source>at least %1 for each, %2 are left</source>
        <translation>每个至少 %1，剩余 %2</translation>
    </message>
    <message>
        <source>at least an item's %1, at most 252</source>
        <translation>至少一项的 %1，至多 252</translation>
    </message>
    <message>
        <source>at least one, and as many as its buffer view holds</source>
        <translation>至少一项，且不多于其缓冲区视图所含</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>at most %1 for a file of its size</source>
        <translation>对此大小的文件至多 %1</translation>
    </message>
    <message>
        <source>at most %1 in each other</source>
        <translation>相互嵌套至多 %1 层</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>至多 %1 层</translation>
    </message>
    <message>
        <source>at most %1 primitives at their places</source>
        <translation>至多 %1 个就位的图元</translation>
    </message>
    <message>
        <source>at most %1 times its size</source>
        <translation>至多为其大小的 %1 倍</translation>
    </message>
    <message>
        <source>at most %1 times its size and %2</source>
        <translation>至多为其大小的 %1 倍及 %2</translation>
    </message>
    <message>
        <source>at most %1, larger ones nested</source>
        <translation>至多 %1，更大的应嵌套</translation>
    </message>
    <message>
        <source>at most 1000 components</source>
        <translation>至多 1000 个分量</translation>
    </message>
    <message>
        <source>at most 1024</source>
        <translation>至多 1024</translation>
    </message>
    <message>
        <source>at most 4294967295</source>
        <translation>至多 4294967295</translation>
    </message>
    <message>
        <source>attributes of a wrong length</source>
        <translation>长度错误的属性</translation>
    </message>
    <message>
        <source>buffer %1 has %2 bytes</source>
        <translation>缓冲区 %1 有 %2 字节</translation>
    </message>
    <message>
        <source>buffer view %1</source>
        <translation>缓冲区视图 %1</translation>
    </message>
    <message>
        <source>buffer view %1 has a stride of %2 bytes</source>
        <translation>缓冲区视图 %1 的步距为 %2 字节</translation>
    </message>
    <message>
        <source>buffer view %1 leaves its buffer</source>
        <translation>缓冲区视图 %1 超出其缓冲区</translation>
    </message>
    <message>
        <source>byte %1: the header promises %2, but there is room for %3</source>
        <translation>第 %1 字节：文件头承诺 %2，而只容得下 %3</translation>
    </message>
    <message>
        <source>bytes of its own for every scan</source>
        <translation>每个扫描各有自己的字节</translation>
    </message>
    <message>
        <source>cartesianX, Y, Z or sphericalRange, Azimuth, Elevation</source>
        <translation>cartesianX、Y、Z 或 sphericalRange、Azimuth、Elevation</translation>
    </message>
    <message>
        <source>cells of %1 numbers</source>
        <translation>%1 个数的单元</translation>
    </message>
    <message>
        <source>char ... double, int8 ... float64 or list</source>
        <translation>char ... double、int8 ... float64 或 list</translation>
    </message>
    <message>
        <source>chunks that fill the bytes up to the chunk table</source>
        <translation>填满块表之前全部字节的块</translation>
    </message>
    <message>
        <source>colours are 8 bit in the file, spread to 16 bit</source>
        <translation>文件中颜色为 8 位，已扩展为 16 位</translation>
    </message>
    <message>
        <source>colours not kept: not every vertex has one</source>
        <translation>颜色未保留：并非每个顶点都有颜色</translation>
    </message>
    <message>
        <source>colours that are neither fractions nor normalised bytes or words are left out</source>
        <translation>略去既不是小数也不是归一化字节或字的颜色</translation>
    </message>
    <message>
        <source>contents of the kind pnts</source>
        <translation>pnts 类的内容</translation>
    </message>
    <message>
        <source>contents of the kind pnts, not %1</source>
        <translation>pnts 类的内容，而不是 %1</translation>
    </message>
    <message>
        <source>coordinates are written as they are, but a unit of the source is %1 m, and glTF counts in metres</source>
        <translation>坐标按原样写出，但源的一个单位为 %1 m，而 glTF 以米计</translation>
    </message>
    <message>
        <source>copies by EXT_mesh_gpu_instancing are left out</source>
        <translation>略去 EXT_mesh_gpu_instancing 的副本</translation>
    </message>
    <message>
        <source>corners behind the last whole triangle are left out</source>
        <translation>略去最后一个完整三角形之后的角点</translation>
    </message>
    <message>
        <source>decimal numbers with '.'</source>
        <translation>以“.”为小数点的数字</translation>
    </message>
    <message>
        <source>different names</source>
        <translation>不同的名称</translation>
    </message>
    <message>
        <source>equal numbers</source>
        <translation>相等的数</translation>
    </message>
    <message>
        <source>every file in a place of its own</source>
        <translation>每个文件各有其位置</translation>
    </message>
    <message>
        <source>every file once</source>
        <translation>每个文件一次</translation>
    </message>
    <message>
        <source>every point once</source>
        <translation>每个点一次</translation>
    </message>
    <message>
        <source>expected: &quot;pnts&quot;, named by %1</source>
        <translation>应为：由 %1 指定的“pnts”</translation>
    </message>
    <message>
        <source>expected: %1</source>
        <translation>应为：%1</translation>
    </message>
    <message>
        <source>expected: a file</source>
        <translation>应为：文件</translation>
    </message>
    <message>
        <source>expected: a point cloud or a mesh</source>
        <translation>应为：点云或网格</translation>
    </message>
    <message>
        <source>expected: at most %1; load a part of it</source>
        <translation>应为：至多 %1；请载入其一部分</translation>
    </message>
    <message>
        <source>export the scan from EXScan as ASC, PLY, OBJ or STL, and the markers as text with x y z on each line</source>
        <translation>请从 EXScan 将扫描导出为 ASC、PLY、OBJ 或 STL，将标志点导出为每行 x y z 的文本</translation>
    </message>
    <message>
        <source>face %1 names a vertex that is not there</source>
        <translation>面 %1 指定了不存在的顶点</translation>
    </message>
    <message>
        <source>fewer buffers</source>
        <translation>更少的缓冲区</translation>
    </message>
    <message>
        <source>files in the archive overlap</source>
        <translation>压缩包中的文件相互重叠</translation>
    </message>
    <message>
        <source>files with the extension '%1' cannot be written</source>
        <translation>扩展名为“%1”的文件不能写出</translation>
    </message>
    <message>
        <source>files within %1</source>
        <translation>%1 之内的文件</translation>
    </message>
    <message>
        <source>finite coordinates</source>
        <translation>有限的坐标</translation>
    </message>
    <message>
        <source>finite coordinates up to 1e10</source>
        <translation>不超过 1e10 的有限坐标</translation>
    </message>
    <message>
        <source>finite numbers</source>
        <translation>有限数</translation>
    </message>
    <message>
        <source>finite numbers of metres</source>
        <translation>有限的米数</translation>
    </message>
    <message>
        <source>finite numbers, and a scale that is not 0</source>
        <translation>有限数，且比例不为 0</translation>
    </message>
    <message>
        <source>first scan %1 x %2</source>
        <translation>第一个扫描 %1 x %2</translation>
    </message>
    <message>
        <source>float, double, int and such</source>
        <translation>float、double、int 等</translation>
    </message>
    <message>
        <source>format, element, property, comment or end_header</source>
        <translation>format、element、property、comment 或 end_header</translation>
    </message>
    <message>
        <source>further notes on this file are not listed</source>
        <translation>此文件的其余说明不再列出</translation>
    </message>
    <message>
        <source>geographic %1</source>
        <translation>地理坐标系 %1</translation>
    </message>
    <message>
        <source>glTF scene</source>
        <translation>glTF 场景</translation>
    </message>
    <message>
        <source>indices below the number of vertices, %1 of these and %2 triangles</source>
        <translation>小于顶点数的索引，这些为 %1，三角形为 %2</translation>
    </message>
    <message>
        <source>it after OFFSETS</source>
        <translation>应在 OFFSETS 之后</translation>
    </message>
    <message>
        <source>it cannot be started</source>
        <translation>它无法启动</translation>
    </message>
    <message>
        <source>it does not begin with its mark</source>
        <translation>它的开头没有其标记</translation>
    </message>
    <message>
        <source>it refused the file without saying why</source>
        <translation>它拒绝了文件而没有说明原因</translation>
    </message>
    <message>
        <source>item %1 of %2 bytes</source>
        <translation>%2 字节的项 %1</translation>
    </message>
    <message>
        <source>its checksum is wrong</source>
        <translation>它的校验和错误</translation>
    </message>
    <message>
        <source>lines 'v x y z'</source>
        <translation>各行为“v x y z”</translation>
    </message>
    <message>
        <source>lines are left out</source>
        <translation>略去线</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>网格 %1</translation>
    </message>
    <message>
        <source>more bytes</source>
        <translation>更多字节</translation>
    </message>
    <message>
        <source>more points than the %1 that the first line promises</source>
        <translation>点数多于第一行承诺的 %1</translation>
    </message>
    <message>
        <source>more than the file can hold</source>
        <translation>多于文件所能容纳</translation>
    </message>
    <message>
        <source>morph targets are left out</source>
        <translation>略去变形目标</translation>
    </message>
    <message>
        <source>names below the archive's root</source>
        <translation>位于压缩包根目录之下的名称</translation>
    </message>
    <message>
        <source>no column is named %1</source>
        <translation>没有名为 %1 的列</translation>
    </message>
    <message>
        <source>no more than its bytes can hold</source>
        <translation>不多于其字节所能容纳</translation>
    </message>
    <message>
        <source>no more than that for a file of its size</source>
        <translation>对此大小的文件不多于此数</translation>
    </message>
    <message>
        <source>no more than that for an archive of this size</source>
        <translation>对此大小的压缩包不多于此数</translation>
    </message>
    <message>
        <source>node %1 has more children than there are nodes</source>
        <translation>节点 %1 的子节点多于节点总数</translation>
    </message>
    <message>
        <source>node %1 stands in the scene twice or holds itself</source>
        <translation>节点 %1 在场景中出现两次或包含自身</translation>
    </message>
    <message>
        <source>normals are not written: glTF has no place for points without one</source>
        <translation>法向量未写出：glTF 无法容纳没有法向量的点</translation>
    </message>
    <message>
        <source>normals not kept: they belong to corners, not to vertices</source>
        <translation>法向量未保留：它们属于角点而不属于顶点</translation>
    </message>
    <message>
        <source>normals that are not float vectors are left out</source>
        <translation>略去不是浮点向量的法向量</translation>
    </message>
    <message>
        <source>not all tiles have the same attributes; those that a tile lacks are zero in its points</source>
        <translation>并非所有瓦片都有相同的属性；瓦片所缺的属性在其点中取为零</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>未保留：%1</translation>
    </message>
    <message>
        <source>not kept: element %1</source>
        <translation>未保留：元素 %1</translation>
    </message>
    <message>
        <source>numbers below %1</source>
        <translation>小于 %1 的数</translation>
    </message>
    <message>
        <source>numbers from 0 to 255</source>
        <translation>0 到 255 的数</translation>
    </message>
    <message>
        <source>numbers in the range of a double</source>
        <translation>双精度范围内的数</translation>
    </message>
    <message>
        <source>numbers that a double can hold</source>
        <translation>双精度所能容纳的数</translation>
    </message>
    <message>
        <source>of %1 points only the first are whole and were read; %2</source>
        <translation>%1 个点中只有开头的完好并已读取；%2</translation>
    </message>
    <message>
        <source>of %1 points the first %2 are whole and were read; %3</source>
        <translation>%1 个点中开头的 %2 个完好并已读取；%3</translation>
    </message>
    <message>
        <source>of the vertices and triangles of a mesh only %1 and %2 can be read</source>
        <translation>网格的顶点和三角形中只能读取 %1 和 %2</translation>
    </message>
    <message>
        <source>offsets that grow up to the connectivity</source>
        <translation>递增到连接表为止的偏移</translation>
    </message>
    <message>
        <source>offsets up to 1e10</source>
        <translation>不超过 1e10 的偏移</translation>
    </message>
    <message>
        <source>one column each of x, y and z</source>
        <translation>x、y、z 各一列</translation>
    </message>
    <message>
        <source>one entry for each field</source>
        <translation>每个字段一项</translation>
    </message>
    <message>
        <source>one file</source>
        <translation>一个文件</translation>
    </message>
    <message>
        <source>one per point</source>
        <translation>每个点一个</translation>
    </message>
    <message>
        <source>one section POINTS</source>
        <translation>一个 POINTS 分区</translation>
    </message>
    <message>
        <source>plain points</source>
        <translation>普通的点</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>point %1 has a coordinate that is no finite number</source>
        <translation>点 %1 的某个坐标不是有限数</translation>
    </message>
    <message>
        <source>point %1 is of batch %2</source>
        <translation>点 %1 属于批次 %2</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>点 %1：%2</translation>
    </message>
    <message>
        <source>point format %1 is unknown</source>
        <translation>点格式 %1 未知</translation>
    </message>
    <message>
        <source>points alone, as 3D Tiles have them</source>
        <translation>如 3D Tiles 所有的单纯的点</translation>
    </message>
    <message>
        <source>points are all read, also those that the file's indices leave out</source>
        <translation>所有点均予读取，包括文件的索引所略去的</translation>
    </message>
    <message>
        <source>points are listed twice</source>
        <translation>点列出了两次</translation>
    </message>
    <message>
        <source>projected %1</source>
        <translation>投影坐标系 %1</translation>
    </message>
    <message>
        <source>readable: %1</source>
        <translation>可读取：%1</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>reading needs more than %1 of memory</source>
        <translation>读取需要的内存超过 %1</translation>
    </message>
    <message>
        <source>reading takes more than %1 s</source>
        <translation>读取用时超过 %1 s</translation>
    </message>
    <message>
        <source>reading takes more than %1 s of the processor</source>
        <translation>读取占用处理器超过 %1 s</translation>
    </message>
    <message>
        <source>record %1 is far from the zone of the first one</source>
        <translation>记录 %1 远离第一条记录所在的投影带</translation>
    </message>
    <message>
        <source>records of %1 bytes</source>
        <translation>%1 字节的记录</translation>
    </message>
    <message>
        <source>scalars of the component type 5121, 5123 or 5125</source>
        <translation>组件类型 5121、5123 或 5125 的标量</translation>
    </message>
    <message>
        <source>scalars or vectors of the types that glTF 2.0 lists</source>
        <translation>glTF 2.0 所列类型的标量或向量</translation>
    </message>
    <message>
        <source>scale and offset of a field do not give usable numbers</source>
        <translation>某个字段的比例和偏移得不出可用的数</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>扫描 %1</translation>
    </message>
    <message>
        <source>scan %1: %2 of %3 could be read: %4</source>
        <translation>扫描 %1：%3中的 %2 可以读取：%4</translation>
    </message>
    <message>
        <source>sections within the tile</source>
        <translation>瓦片之内的分区</translation>
    </message>
    <message>
        <source>skins are left out: their meshes stand as they are stored</source>
        <translation>略去蒙皮：其网格保持存储时的样子</translation>
    </message>
    <message>
        <source>some for %1</source>
        <translation>%1 应有一些</translation>
    </message>
    <message>
        <source>stored or deflated files</source>
        <translation>存储或 deflate 压缩的文件</translation>
    </message>
    <message>
        <source>that of the tables</source>
        <translation>各表的长度</translation>
    </message>
    <message>
        <source>the %1 that the document promises</source>
        <translation>文档承诺的 %1</translation>
    </message>
    <message>
        <source>the CRC-32C of the page's content</source>
        <translation>页内容的 CRC-32C</translation>
    </message>
    <message>
        <source>the Draco stream</source>
        <translation>Draco 流</translation>
    </message>
    <message>
        <source>the Draco stream cannot be decoded: %1</source>
        <translation>Draco 流无法解码：%1</translation>
    </message>
    <message>
        <source>the Draco stream decodes to %1</source>
        <translation>Draco 流解码得到 %1</translation>
    </message>
    <message>
        <source>the Draco stream does not say its length</source>
        <translation>Draco 流没有说明其长度</translation>
    </message>
    <message>
        <source>the Draco stream ends early</source>
        <translation>Draco 流过早结束</translation>
    </message>
    <message>
        <source>the Draco stream has %1</source>
        <translation>Draco 流有 %1</translation>
    </message>
    <message>
        <source>the Draco stream has an attribute of type %1 with %2</source>
        <translation>Draco 流有一个类型为 %1、含 %2的属性</translation>
    </message>
    <message>
        <source>the Draco stream has another type of %1</source>
        <translation>Draco 流的 %1 类型不同</translation>
    </message>
    <message>
        <source>the Draco stream has no attribute %1 for %2</source>
        <translation>Draco 流没有 %2 所用的属性 %1</translation>
    </message>
    <message>
        <source>the Draco stream has the method %1</source>
        <translation>Draco 流采用方法 %1</translation>
    </message>
    <message>
        <source>the Draco stream has too few values of %1</source>
        <translation>Draco 流的 %1 值太少</translation>
    </message>
    <message>
        <source>the Draco stream has version %1.%2</source>
        <translation>Draco 流的版本为 %1.%2</translation>
    </message>
    <message>
        <source>the Draco stream holds %1, the feature table promises %2</source>
        <translation>Draco 流含有 %1，而要素表承诺 %2</translation>
    </message>
    <message>
        <source>the Draco stream holds a number of more than 32 bits</source>
        <translation>Draco 流含有超过 32 位的数</translation>
    </message>
    <message>
        <source>the Draco stream holds metadata</source>
        <translation>Draco 流含有元数据</translation>
    </message>
    <message>
        <source>the Draco stream is a mesh</source>
        <translation>Draco 流是网格</translation>
    </message>
    <message>
        <source>the Draco stream leaves points without %1</source>
        <translation>Draco 流使一些点没有 %1</translation>
    </message>
    <message>
        <source>the Draco stream of %1 promises %2 of %3</source>
        <translation>%1的 Draco 流承诺 %2 的 %3</translation>
    </message>
    <message>
        <source>the GPS time is no finite number</source>
        <translation>GPS 时间不是有限数</translation>
    </message>
    <message>
        <source>the GeoTIFF keys are damaged; the coordinate reference system is unknown</source>
        <translation>GeoTIFF 键已损坏；坐标参考系未知</translation>
    </message>
    <message>
        <source>the JSON holds %1 values</source>
        <translation>JSON 含有 %1 个值</translation>
    </message>
    <message>
        <source>the JSON is nested %1 deep</source>
        <translation>JSON 嵌套 %1 层</translation>
    </message>
    <message>
        <source>the JSON is nested too deep</source>
        <translation>JSON 嵌套过深</translation>
    </message>
    <message>
        <source>the JSON is no object</source>
        <translation>JSON 不是对象</translation>
    </message>
    <message>
        <source>the JSON of S3M 3.0 or 3.01</source>
        <translation>S3M 3.0 或 3.01 的 JSON</translation>
    </message>
    <message>
        <source>the S3MB tile ends before %1 times %2</source>
        <translation>S3MB 瓦片在 %2的 %1 倍之前结束</translation>
    </message>
    <message>
        <source>the S3MB tile has version %1</source>
        <translation>S3MB 瓦片的版本为 %1</translation>
    </message>
    <message>
        <source>the S3MB tile holds instances</source>
        <translation>S3MB 瓦片含有实例</translation>
    </message>
    <message>
        <source>the S3MB tile is packed in the way %1</source>
        <translation>S3MB 瓦片以方式 %1 打包</translation>
    </message>
    <message>
        <source>the S3MB tile promises %1 things of at least %2</source>
        <translation>S3MB 瓦片承诺 %1 项，每项至少 %2</translation>
    </message>
    <message>
        <source>the XML section</source>
        <translation>XML 分区</translation>
    </message>
    <message>
        <source>the XML section cannot be parsed: %1</source>
        <translation>XML 分区无法解析：%1</translation>
    </message>
    <message>
        <source>the XML section has no root</source>
        <translation>XML 分区没有根元素</translation>
    </message>
    <message>
        <source>the XML section is too large: %1</source>
        <translation>XML 分区太大：%1</translation>
    </message>
    <message>
        <source>the XML section of %1 reaches beyond the file</source>
        <translation>%1的 XML 分区超出文件</translation>
    </message>
    <message>
        <source>the archive holds '%1' twice</source>
        <translation>压缩包中“%1”出现了两次</translation>
    </message>
    <message>
        <source>the attributes that the tables name</source>
        <translation>各表所列的属性</translation>
    </message>
    <message>
        <source>the batch table</source>
        <translation>批次表</translation>
    </message>
    <message>
        <source>the bounds in the header are not those of the points</source>
        <translation>文件头中的范围不是各点的范围</translation>
    </message>
    <message>
        <source>the buffer '%1' is a link that leads out of the document's folder</source>
        <translation>缓冲区“%1”是指向文档所在文件夹之外的链接</translation>
    </message>
    <message>
        <source>the buffer '%1' of the document is missing</source>
        <translation>缺少文档的缓冲区“%1”</translation>
    </message>
    <message>
        <source>the byte streams of a packet are longer than it</source>
        <translation>某个数据包的字节流长于数据包</translation>
    </message>
    <message>
        <source>the bytes of an image are damaged</source>
        <translation>某个图像的字节已损坏</translation>
    </message>
    <message>
        <source>the children are no list</source>
        <translation>子节点不是列表</translation>
    </message>
    <message>
        <source>the chunk table has no chunks</source>
        <translation>块表没有块</translation>
    </message>
    <message>
        <source>the chunk table is said to be at byte %1</source>
        <translation>块表据称位于第 %1 字节</translation>
    </message>
    <message>
        <source>the chunk table promises %1</source>
        <translation>块表承诺 %1</translation>
    </message>
    <message>
        <source>the chunks hold %1 points</source>
        <translation>各块含有 %1 个点</translation>
    </message>
    <message>
        <source>the cloud stands at longitude %1, latitude %2, height %3 (%4); it is read in its own frame there, in metres</source>
        <translation>点云位于经度 %1、纬度 %2、高程 %3（%4）；在该处按其自身坐标系以米读取</translation>
    </message>
    <message>
        <source>the column %1 is named twice</source>
        <translation>列 %1 出现了两次</translation>
    </message>
    <message>
        <source>the compressed points are damaged</source>
        <translation>压缩的点已损坏</translation>
    </message>
    <message>
        <source>the compressed points are damaged: %1</source>
        <translation>压缩的点已损坏：%1</translation>
    </message>
    <message>
        <source>the compressed points are damaged: LASzip gives up</source>
        <translation>压缩的点已损坏：LASzip 放弃读取</translation>
    </message>
    <message>
        <source>the compressed points from number %1 are damaged</source>
        <translation>从第 %1 个起压缩的点已损坏</translation>
    </message>
    <message>
        <source>the content names no file</source>
        <translation>内容没有指定文件</translation>
    </message>
    <message>
        <source>the coordinates are latitudes and longitudes in degrees; no lengths can be measured in them</source>
        <translation>坐标是以度为单位的经纬度；不能据此测量长度</translation>
    </message>
    <message>
        <source>the directory of the zip archive lies outside of it</source>
        <translation>zip 压缩包的目录位于包外</translation>
    </message>
    <message>
        <source>the disk could not read all of the file</source>
        <translation>磁盘未能读取整个文件</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>the document names the buffer '%1'</source>
        <translation>文档指定了缓冲区“%1”</translation>
    </message>
    <message>
        <source>the document says no version</source>
        <translation>文档没有说明版本</translation>
    </message>
    <message>
        <source>the element has no name or no count</source>
        <translation>元素没有名称或没有计数</translation>
    </message>
    <message>
        <source>the element has no properties</source>
        <translation>元素没有属性</translation>
    </message>
    <message>
        <source>the encoding '%1' is unknown</source>
        <translation>编码“%1”未知</translation>
    </message>
    <message>
        <source>the encoding is unknown</source>
        <translation>编码未知</translation>
    </message>
    <message>
        <source>the encoding of DATA is unknown</source>
        <translation>DATA 的编码未知</translation>
    </message>
    <message>
        <source>the field %1 has a TYPE and SIZE that do not exist together</source>
        <translation>字段 %1 的 TYPE 和 SIZE 不能同时成立</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>无法读取文件</translation>
    </message>
    <message>
        <source>the file cannot be read on: it became shorter, or its device fails</source>
        <translation>文件无法继续读取：它变短了，或其设备出现故障</translation>
    </message>
    <message>
        <source>the file does not begin with 'ASTM-E57'</source>
        <translation>文件开头不是“ASTM-E57”</translation>
    </message>
    <message>
        <source>the file does not begin with 'ply'</source>
        <translation>文件开头不是“ply”</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>文件在 %1 之后结束</translation>
    </message>
    <message>
        <source>the file ends after %1 bytes of compressed points</source>
        <translation>文件在 %1 字节的压缩点之后结束</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2</source>
        <translation>文件在 %2中的 %1 之后结束</translation>
    </message>
    <message>
        <source>the file ends before %1</source>
        <translation>文件在 %1 之前结束</translation>
    </message>
    <message>
        <source>the file ends before %1 values</source>
        <translation>文件在 %1 个值之前结束</translation>
    </message>
    <message>
        <source>the file ends before its %1</source>
        <translation>文件在其 %1 之前结束</translation>
    </message>
    <message>
        <source>the file ends before its last value</source>
        <translation>文件在其最后一个值之前结束</translation>
    </message>
    <message>
        <source>the file ends before the compressed points</source>
        <translation>文件在压缩的点之前结束</translation>
    </message>
    <message>
        <source>the file ends before the sizes</source>
        <translation>文件在各大小之前结束</translation>
    </message>
    <message>
        <source>the file ends early</source>
        <translation>文件过早结束</translation>
    </message>
    <message>
        <source>the file ends early: %1 of %2 were read</source>
        <translation>文件过早结束：%2中读取了 %1</translation>
    </message>
    <message>
        <source>the file ends inside a record</source>
        <translation>文件在某条记录之内结束</translation>
    </message>
    <message>
        <source>the file ends inside a scan's header</source>
        <translation>文件在某个扫描的文件头之内结束</translation>
    </message>
    <message>
        <source>the file ends inside its Draco stream</source>
        <translation>文件在其 Draco 流之内结束</translation>
    </message>
    <message>
        <source>the file ends inside its first record</source>
        <translation>文件在其第一条记录之内结束</translation>
    </message>
    <message>
        <source>the file ends inside its header</source>
        <translation>文件在其文件头之内结束</translation>
    </message>
    <message>
        <source>the file ends inside its mesh</source>
        <translation>文件在其网格之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the S3MB tile</source>
        <translation>文件在 S3MB 瓦片之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the feature table</source>
        <translation>文件在要素表之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the header</source>
        <translation>文件在文件头之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the header of the S3MB tile</source>
        <translation>文件在 S3MB 瓦片的文件头之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the header of the point tile</source>
        <translation>文件在点瓦片的文件头之内结束</translation>
    </message>
    <message>
        <source>the file ends inside the point tile</source>
        <translation>文件在点瓦片之内结束</translation>
    </message>
    <message>
        <source>the file ends too early; its header promises %1</source>
        <translation>文件过早结束；其文件头承诺 %1</translation>
    </message>
    <message>
        <source>the file goes on behind its last facet</source>
        <translation>文件在其最后一个面片之后还有内容</translation>
    </message>
    <message>
        <source>the file has more scans than can be told apart</source>
        <translation>文件中的扫描多得无法区分</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>文件没有点</translation>
    </message>
    <message>
        <source>the file has no row of numbers</source>
        <translation>文件没有由数字组成的行</translation>
    </message>
    <message>
        <source>the file has no scan</source>
        <translation>文件没有扫描</translation>
    </message>
    <message>
        <source>the file has no vertices</source>
        <translation>文件没有顶点</translation>
    </message>
    <message>
        <source>the file holds more points than Vestige can number</source>
        <translation>文件中的点多于 Vestige 所能编号</translation>
    </message>
    <message>
        <source>the file is cut off: there is room for %1 of the %2 that its header names</source>
        <translation>文件被截断：其文件头所列的 %2中只容得下 %1</translation>
    </message>
    <message>
        <source>the file is damaged%1: %2; %3 are whole and were read</source>
        <translation>文件已损坏%1：%2；%3完好并已读取</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the file lists no points</source>
        <translation>文件没有列出点</translation>
    </message>
    <message>
        <source>the file promises %1, but it ends too early for them</source>
        <translation>文件承诺 %1，但过早结束而容不下</translation>
    </message>
    <message>
        <source>the file repeats its %1 until it has %2</source>
        <translation>文件重复其 %1，直至有 %2</translation>
    </message>
    <message>
        <source>the file repeats its objects until they have more than %1 %2</source>
        <translation>文件重复其对象，直至超过 %1 个%2</translation>
    </message>
    <message>
        <source>the file requires the extension %1, which is not read here</source>
        <translation>文件需要扩展 %1，此处不读取该扩展</translation>
    </message>
    <message>
        <source>the file should have %1 bytes</source>
        <translation>文件应有 %1 字节</translation>
    </message>
    <message>
        <source>the files in the archive are together more than %1 bytes</source>
        <translation>压缩包中的文件合计超过 %1 字节</translation>
    </message>
    <message>
        <source>the first %1</source>
        <translation>开头的 %1</translation>
    </message>
    <message>
        <source>the first %1 and %2</source>
        <translation>开头的 %1 和 %2</translation>
    </message>
    <message>
        <source>the first %1 of %2</source>
        <translation>%2中开头的 %1</translation>
    </message>
    <message>
        <source>the first chunk, and no other, must be JSON</source>
        <translation>第一个块必须是 JSON，其他块不得是 JSON</translation>
    </message>
    <message>
        <source>the first line of a PLY file</source>
        <translation>PLY 文件的第一行</translation>
    </message>
    <message>
        <source>the folder of the tileset cannot be found: %1</source>
        <translation>找不到瓦片集的文件夹：%1</translation>
    </message>
    <message>
        <source>the format %1 is read only</source>
        <translation>格式 %1 只能读取</translation>
    </message>
    <message>
        <source>the header does not say how many points there are</source>
        <translation>文件头没有说明有多少个点</translation>
    </message>
    <message>
        <source>the header ends without points</source>
        <translation>文件头结束而没有点</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>文件头没有结尾</translation>
    </message>
    <message>
        <source>the header has no line FIELDS before DATA</source>
        <translation>文件头在 DATA 之前没有 FIELDS 行</translation>
    </message>
    <message>
        <source>the header is said to have %1</source>
        <translation>据称文件头有 %1</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>文件头没有指定格式</translation>
    </message>
    <message>
        <source>the header of a scan is broken here</source>
        <translation>某个扫描的文件头在此处损坏</translation>
    </message>
    <message>
        <source>the header of the scan's section is cut off or damaged</source>
        <translation>扫描分区的头被截断或已损坏</translation>
    </message>
    <message>
        <source>the header promises %1 of element '%2', but the file ends too early for them</source>
        <translation>文件头承诺元素“%2”有 %1，但文件过早结束而容不下</translation>
    </message>
    <message>
        <source>the header promises %1 points of %2 bytes, but the file has room for %3</source>
        <translation>文件头承诺 %1 个 %2 字节的点，而文件只容得下 %3</translation>
    </message>
    <message>
        <source>the header promises %1 points, but the file ends too early for them</source>
        <translation>文件头承诺 %1 个点，但文件过早结束而容不下</translation>
    </message>
    <message>
        <source>the header promises %1 points, but the file has room for %2</source>
        <translation>文件头承诺 %1 个点，而文件只容得下 %2</translation>
    </message>
    <message>
        <source>the header promises %1 points, more than the compressed bytes of any scan hold</source>
        <translation>文件头承诺 %1 个点，多于任何扫描的压缩字节所能容纳</translation>
    </message>
    <message>
        <source>the height is beyond 100 km</source>
        <translation>高度超过 100 km</translation>
    </message>
    <message>
        <source>the heights are in %1, the positions in %2; lengths that are not level come out wrong until the file is converted</source>
        <translation>高程单位为%1，平面位置单位为%2；在转换文件之前，不水平的长度结果将是错误的</translation>
    </message>
    <message>
        <source>the image '%1' has neither a JPEG nor a PNG picture</source>
        <translation>图像“%1”既没有 JPEG 图片也没有 PNG 图片</translation>
    </message>
    <message>
        <source>the index has %1</source>
        <translation>索引有 %1</translation>
    </message>
    <message>
        <source>the index has the lodType '%1'</source>
        <translation>索引的 lodType 为“%1”</translation>
    </message>
    <message>
        <source>the index is one of '%1'</source>
        <translation>索引属于“%1”</translation>
    </message>
    <message>
        <source>the index names no tiles</source>
        <translation>索引没有指定瓦片</translation>
    </message>
    <message>
        <source>the indices of %1 are no whole numbers</source>
        <translation>%1 的索引不是整数</translation>
    </message>
    <message>
        <source>the indices of a sparse accessor of %1 are of the type %2</source>
        <translation>%1 的稀疏访问器的索引类型为 %2</translation>
    </message>
    <message>
        <source>the keys &quot;asset&quot; and &quot;root&quot;</source>
        <translation>键 &quot;asset&quot; 和 &quot;root&quot;</translation>
    </message>
    <message>
        <source>the last %1 of the file are missing</source>
        <translation>缺少文件最后的 %1</translation>
    </message>
    <message>
        <source>the latitude is beyond a pole</source>
        <translation>纬度超过极点</translation>
    </message>
    <message>
        <source>the least value of a field is above its largest</source>
        <translation>某个字段的最小值大于其最大值</translation>
    </message>
    <message>
        <source>the levels of detail</source>
        <translation>各细节层次</translation>
    </message>
    <message>
        <source>the line DATASET is missing</source>
        <translation>缺少 DATASET 行</translation>
    </message>
    <message>
        <source>the line has no single value</source>
        <translation>该行没有单一的值</translation>
    </message>
    <message>
        <source>the line is too long for a row of numbers</source>
        <translation>该行太长，不可能是一行数字</translation>
    </message>
    <message>
        <source>the longitude is beyond a full turn</source>
        <translation>经度超过一整圈</translation>
    </message>
    <message>
        <source>the matrix of a node has another last row than 0 0 0 1</source>
        <translation>某个节点的矩阵最后一行不是 0 0 0 1</translation>
    </message>
    <message>
        <source>the matrix of a patch is not affine and invertible</source>
        <translation>某个面片的矩阵不是可逆的仿射矩阵</translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation>%1的个数</translation>
    </message>
    <message>
        <source>the number of points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>the numbers of this row have decimal commas</source>
        <translation>此行数字使用了逗号小数点</translation>
    </message>
    <message>
        <source>the numbers x, y and z</source>
        <translation>数 x、y 和 z</translation>
    </message>
    <message>
        <source>the octree of the COPC file does not fit its points; they are read as those of a plain LAZ file</source>
        <translation>COPC 文件的八叉树与其点不符；按普通 LAZ 文件读取</translation>
    </message>
    <message>
        <source>the page has another checksum than it says: the file is damaged here</source>
        <translation>该页的校验和与所述不同：文件在此处损坏</translation>
    </message>
    <message>
        <source>the pages cannot be of %1 bytes</source>
        <translation>页不可能为 %1 字节</translation>
    </message>
    <message>
        <source>the place of an object is no finite number</source>
        <translation>某个对象的位置不是有限数</translation>
    </message>
    <message>
        <source>the point tile has version %1</source>
        <translation>点瓦片的版本为 %1</translation>
    </message>
    <message>
        <source>the points are said to begin at byte %1</source>
        <translation>点据称从第 %1 字节开始</translation>
    </message>
    <message>
        <source>the points have %1 coordinates</source>
        <translation>点有 %1 个坐标</translation>
    </message>
    <message>
        <source>the points have more values than any file needs</source>
        <translation>点的值多于任何文件所需</translation>
    </message>
    <message>
        <source>the points have no positions</source>
        <translation>点没有位置</translation>
    </message>
    <message>
        <source>the points of %1 are of another type</source>
        <translation>%1 的点是另一种类型</translation>
    </message>
    <message>
        <source>the points of %1 have no coordinates</source>
        <translation>%1 的点没有坐标</translation>
    </message>
    <message>
        <source>the points' bounds</source>
        <translation>点的范围</translation>
    </message>
    <message>
        <source>the position of the index has the unit '%1'</source>
        <translation>索引的位置单位为“%1”</translation>
    </message>
    <message>
        <source>the position of the index is no point</source>
        <translation>索引的位置不是点</translation>
    </message>
    <message>
        <source>the positions of %1 are not float vectors</source>
        <translation>%1 的位置不是浮点向量</translation>
    </message>
    <message>
        <source>the program vestige-import, which reads this format, is missing</source>
        <translation>缺少读取此格式的程序 vestige-import</translation>
    </message>
    <message>
        <source>the property %1 has no known type</source>
        <translation>属性 %1 没有已知的类型</translation>
    </message>
    <message>
        <source>the property belongs to no element</source>
        <translation>该属性不属于任何元素</translation>
    </message>
    <message>
        <source>the property has no name</source>
        <translation>该属性没有名称</translation>
    </message>
    <message>
        <source>the prototype has too many fields</source>
        <translation>原型的字段太多</translation>
    </message>
    <message>
        <source>the prototype is nested too deep</source>
        <translation>原型嵌套过深</translation>
    </message>
    <message>
        <source>the quantised positions have no volume</source>
        <translation>量化的位置没有体积范围</translation>
    </message>
    <message>
        <source>the record 'laszip encoded' 22204</source>
        <translation>记录“laszip encoded”22204</translation>
    </message>
    <message>
        <source>the reference system is not in WKT and is not written: %1</source>
        <translation>参考系不是 WKT 格式，未写出：%1</translation>
    </message>
    <message>
        <source>the rest cannot be read: %1</source>
        <translation>其余部分无法读取：%1</translation>
    </message>
    <message>
        <source>the returns are numbered from 1 in the file, which the standard counts from 0</source>
        <translation>文件中回波从 1 起编号，而标准从 0 起</translation>
    </message>
    <message>
        <source>the rotation of a node is zero</source>
        <translation>某个节点的旋转为零</translation>
    </message>
    <message>
        <source>the rotation of the pose is no unit quaternion</source>
        <translation>位姿的旋转不是单位四元数</translation>
    </message>
    <message>
        <source>the row has %1</source>
        <translation>该行有 %1</translation>
    </message>
    <message>
        <source>the scan ends after %1 of %2</source>
        <translation>扫描在 %2中的 %1 之后结束</translation>
    </message>
    <message>
        <source>the scan's data</source>
        <translation>扫描的数据</translation>
    </message>
    <message>
        <source>the scan's data begin outside of its section</source>
        <translation>扫描的数据从其分区之外开始</translation>
    </message>
    <message>
        <source>the scanner's %1 axis</source>
        <translation>扫描仪的 %1 轴</translation>
    </message>
    <message>
        <source>the scanner's place</source>
        <translation>扫描仪的位置</translation>
    </message>
    <message>
        <source>the scanner's place of %1 is %2 from where its transform puts it; the transform counts</source>
        <translation>%1 的扫描仪位置与其变换所给位置相距 %2；以变换为准</translation>
    </message>
    <message>
        <source>the scans have more bytes together than the file, so they share them</source>
        <translation>各扫描的字节合计多于文件，因此它们共用字节</translation>
    </message>
    <message>
        <source>the scene has its bytes in more than %1 buffers</source>
        <translation>场景的字节位于超过 %1 个缓冲区中</translation>
    </message>
    <message>
        <source>the scene repeats its meshes without end</source>
        <translation>场景无休止地重复其网格</translation>
    </message>
    <message>
        <source>the section '%1' is unknown</source>
        <translation>分区“%1”未知</translation>
    </message>
    <message>
        <source>the section ends inside a packet</source>
        <translation>分区在某个数据包之内结束</translation>
    </message>
    <message>
        <source>the section of a scan is of another kind</source>
        <translation>某个扫描的分区是另一种类型</translation>
    </message>
    <message>
        <source>the section of an image is of another kind or length than its XML says</source>
        <translation>某个图像的分区类型或长度与其 XML 所述不同</translation>
    </message>
    <message>
        <source>the sections of the point tile end at byte %1, the tile at byte %2</source>
        <translation>点瓦片的各分区在第 %1 字节结束，瓦片在第 %2 字节结束</translation>
    </message>
    <message>
        <source>the separate reader %1 cannot start</source>
        <translation>独立读取程序 %1 无法启动</translation>
    </message>
    <message>
        <source>the separate reader cannot be given its files</source>
        <translation>无法将文件交给独立读取程序</translation>
    </message>
    <message>
        <source>the separate reader cannot start</source>
        <translation>独立读取程序无法启动</translation>
    </message>
    <message>
        <source>the separate reader of this format crashed on the file (signal %1)</source>
        <translation>此格式的独立读取程序在该文件上崩溃（信号 %1）</translation>
    </message>
    <message>
        <source>the separate reader of this format gave up on the file (status %1)</source>
        <translation>此格式的独立读取程序放弃了该文件（状态 %1）</translation>
    </message>
    <message>
        <source>the separate reader of this format sent no geometry: %1</source>
        <translation>此格式的独立读取程序没有送回几何数据：%1</translation>
    </message>
    <message>
        <source>the signature LASF</source>
        <translation>签名 LASF</translation>
    </message>
    <message>
        <source>the signature of an E57 file</source>
        <translation>E57 文件的签名</translation>
    </message>
    <message>
        <source>the size of the points does not fit the header</source>
        <translation>点的大小与文件头不符</translation>
    </message>
    <message>
        <source>the sizes of '%1' contradict each other</source>
        <translation>“%1”的各个大小相互矛盾</translation>
    </message>
    <message>
        <source>the skeleton '%1' is placed twice</source>
        <translation>骨架“%1”放置了两次</translation>
    </message>
    <message>
        <source>the skeletons</source>
        <translation>各骨架</translation>
    </message>
    <message>
        <source>the table of the compressed points is missing or damaged; all %1 could be read without it</source>
        <translation>压缩点的表缺失或已损坏；没有它也能读取全部 %1</translation>
    </message>
    <message>
        <source>the tile</source>
        <translation>瓦片</translation>
    </message>
    <message>
        <source>the tile %1 cannot be found: %2</source>
        <translation>找不到瓦片 %1：%2</translation>
    </message>
    <message>
        <source>the tile %1 has an absolute path</source>
        <translation>瓦片 %1 的路径是绝对路径</translation>
    </message>
    <message>
        <source>the tile %1 has no file name</source>
        <translation>瓦片 %1 没有文件名</translation>
    </message>
    <message>
        <source>the tile %1 is missing</source>
        <translation>缺少瓦片 %1</translation>
    </message>
    <message>
        <source>the tile %1 is no file</source>
        <translation>瓦片 %1 不是文件</translation>
    </message>
    <message>
        <source>the tile %1 is not a file beside it</source>
        <translation>瓦片 %1 不是其旁边的文件</translation>
    </message>
    <message>
        <source>the tile %1 lies outside the folder</source>
        <translation>瓦片 %1 位于文件夹之外</translation>
    </message>
    <message>
        <source>the tile '%1' is named a second time</source>
        <translation>瓦片“%1”被第二次指定</translation>
    </message>
    <message>
        <source>the tile is no object</source>
        <translation>瓦片不是对象</translation>
    </message>
    <message>
        <source>the tile refines by '%1'</source>
        <translation>瓦片按“%1”细化</translation>
    </message>
    <message>
        <source>the tiles are divided implicitly, which Vestige does not read</source>
        <translation>瓦片以隐式方式划分，Vestige 不读取</translation>
    </message>
    <message>
        <source>the tiles are nested too deep</source>
        <translation>瓦片嵌套过深</translation>
    </message>
    <message>
        <source>the tiles hold more points than Vestige can number</source>
        <translation>各瓦片中的点多于 Vestige 所能编号</translation>
    </message>
    <message>
        <source>the tileset does not say how its tiles refine each other; REPLACE is assumed</source>
        <translation>瓦片集没有说明各瓦片如何相互细化；假定为 REPLACE</translation>
    </message>
    <message>
        <source>the tileset has %1</source>
        <translation>瓦片集有 %1</translation>
    </message>
    <message>
        <source>the tileset names no point tiles</source>
        <translation>瓦片集没有指定点瓦片</translation>
    </message>
    <message>
        <source>the tilesets are nested too deep</source>
        <translation>瓦片集嵌套过深</translation>
    </message>
    <message>
        <source>the time goes back at %1; the records are in the order of the file</source>
        <translation>时间在 %1 处倒退；记录保持文件中的顺序</translation>
    </message>
    <message>
        <source>the transform is no matrix</source>
        <translation>变换不是矩阵</translation>
    </message>
    <message>
        <source>the transform is not affine</source>
        <translation>变换不是仿射的</translation>
    </message>
    <message>
        <source>the transform is not affine and invertible</source>
        <translation>变换不是可逆的仿射变换</translation>
    </message>
    <message>
        <source>the transform of %1 scales, shears or mirrors; its points are as it says, its pose is the nearest one</source>
        <translation>%1 的变换含缩放、剪切或镜像；其点按该变换，其位姿取最接近者</translation>
    </message>
    <message>
        <source>the translation of the pose is not finite</source>
        <translation>位姿的平移不是有限数</translation>
    </message>
    <message>
        <source>the zip archive has no directory at its end</source>
        <translation>zip 压缩包末尾没有目录</translation>
    </message>
    <message>
        <source>the zip archive holds %1 files</source>
        <translation>zip 压缩包含有 %1 个文件</translation>
    </message>
    <message>
        <source>the zip archive is split over several files</source>
        <translation>zip 压缩包分割在多个文件中</translation>
    </message>
    <message>
        <source>the zip64 directory is not where the archive says</source>
        <translation>zip64 目录不在压缩包所述之处</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>没有 %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>this JSON is no tileset of 3D Tiles</source>
        <translation>此 JSON 不是 3D Tiles 的瓦片集</translation>
    </message>
    <message>
        <source>this index is XML, of S3M before 3.0</source>
        <translation>此索引为 XML，属于 3.0 之前的 S3M</translation>
    </message>
    <message>
        <source>this is a Vestige case, no cloud</source>
        <translation>这是 Vestige 案件，不是点云</translation>
    </message>
    <message>
        <source>this is an EinScan marker file (P3), whose layout its maker has not published</source>
        <translation>这是 EinScan 标志点文件 (P3)，其制造商未公布格式</translation>
    </message>
    <message>
        <source>this is glTF of another version than 2</source>
        <translation>这是版本不为 2 的 glTF</translation>
    </message>
    <message>
        <source>this is glTF of the version '%1'</source>
        <translation>这是版本为“%1”的 glTF</translation>
    </message>
    <message>
        <source>this is more than a glTF file can hold, 4 GiB</source>
        <translation>这超过了 glTF 文件的容量 4 GiB</translation>
    </message>
    <message>
        <source>this is neither a binary nor a text STL file</source>
        <translation>这既不是二进制也不是文本的 STL 文件</translation>
    </message>
    <message>
        <source>this is neither a row of numbers nor a row of column names</source>
        <translation>这既不是一行数字，也不是一行列名</translation>
    </message>
    <message>
        <source>this is no Draco stream</source>
        <translation>这不是 Draco 流</translation>
    </message>
    <message>
        <source>this is no JSON</source>
        <translation>这不是 JSON</translation>
    </message>
    <message>
        <source>this is no LAS file</source>
        <translation>这不是 LAS 文件</translation>
    </message>
    <message>
        <source>this is no S3MB tile</source>
        <translation>这不是 S3MB 瓦片</translation>
    </message>
    <message>
        <source>this is no legacy VTK file</source>
        <translation>这不是旧式 VTK 文件</translation>
    </message>
    <message>
        <source>this is no number of %1</source>
        <translation>这不是 %1 的数目</translation>
    </message>
    <message>
        <source>this is no point tile</source>
        <translation>这不是点瓦片</translation>
    </message>
    <message>
        <source>this is no regular file</source>
        <translation>这不是普通文件</translation>
    </message>
    <message>
        <source>this is no tile of a known kind</source>
        <translation>这不是已知类型的瓦片</translation>
    </message>
    <message>
        <source>this is no zip archive</source>
        <translation>这不是 zip 压缩包</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>这不是 JSON</translation>
    </message>
    <message>
        <source>this is not a kind of file that Vestige reads</source>
        <translation>Vestige 不读取此类文件</translation>
    </message>
    <message>
        <source>this line does not belong into a PCD header</source>
        <translation>此行不应出现在 PCD 文件头中</translation>
    </message>
    <message>
        <source>three lines 'vertex x y z'</source>
        <translation>三行“vertex x y z”</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>三个数</translation>
    </message>
    <message>
        <source>three or more</source>
        <translation>三个或更多</translation>
    </message>
    <message>
        <source>tiles that are listed; export the cloud as LAS, or as 3D Tiles 1.0</source>
        <translation>列出的瓦片；请将点云导出为 LAS 或 3D Tiles 1.0</translation>
    </message>
    <message>
        <source>time, latitude and longitude in radians, height in metres</source>
        <translation>时间，以弧度表示的纬度和经度，以米表示的高度</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>two scans are said to lie in the same section</source>
        <translation>据称两个扫描位于同一分区</translation>
    </message>
    <message>
        <source>two skeletons have the name %1</source>
        <translation>两个骨架的名称为 %1</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>单位 %1</translation>
    </message>
    <message>
        <source>user defined</source>
        <translation>用户自定义</translation>
    </message>
    <message>
        <source>value %1 is missing or no number</source>
        <translation>第 %1 个值缺失或不是数</translation>
    </message>
    <message>
        <source>value %1 is no number</source>
        <translation>第 %1 个值不是数</translation>
    </message>
    <message>
        <source>velocities, attitude and rates of the trajectory are not kept</source>
        <translation>轨迹的速度、姿态和角速率未保留</translation>
    </message>
    <message>
        <source>version %1.%2 is unknown</source>
        <translation>版本 %1.%2 未知</translation>
    </message>
    <message>
        <source>version 0 and %1 chunks at most</source>
        <translation>版本 0，且至多 %1 块</translation>
    </message>
    <message>
        <source>version 3.0 or 3.01</source>
        <translation>版本 3.0 或 3.01</translation>
    </message>
    <message>
        <source>vertex %1: %2</source>
        <translation>顶点 %1：%2</translation>
    </message>
    <message>
        <source>vertical %1</source>
        <translation>垂直坐标系 %1</translation>
    </message>
    <message>
        <source>vestige-import beside this program</source>
        <translation>本程序旁边的 vestige-import</translation>
    </message>
    <message>
        <source>w, x, y, z of length 1</source>
        <translation>长度为 1 的 w、x、y、z</translation>
    </message>
    <message>
        <source>well-formed XML</source>
        <translation>格式良好的 XML</translation>
    </message>
    <message>
        <source>what its length allows</source>
        <translation>其长度所允许的数量</translation>
    </message>
    <message>
        <source>whole numbers from 0</source>
        <translation>从 0 起的整数</translation>
    </message>
    <message>
        <source>whole numbers from 1, or from -1 down to what was read before</source>
        <translation>从 1 起的整数，或从 -1 往回数到此前已读取的</translation>
    </message>
    <message>
        <source>whole pages</source>
        <translation>整数页</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>writable: %1</source>
        <translation>可写出：%1</translation>
    </message>
    <message>
        <source>write LAS or PLY, or thin the points</source>
        <translation>请写成 LAS 或 PLY，或稀释各点</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>写出</translation>
    </message>
    <message>
        <source>x y z and what else there is of intensity, colour and normals, or their names</source>
        <translation>x y z 以及其余的强度、颜色和法向量，或它们的名称</translation>
    </message>
    <message>
        <source>x y z on each line</source>
        <translation>每行 x y z</translation>
    </message>
</context>
<context>
    <name>core/measurement</name>
    <message>
        <source>%1 points within %2 mm</source>
        <translation>%2 mm 内有 %1 个点</translation>
    </message>
    <message>
        <source>'%1' in the column '%2' is not a length</source>
        <translation>“%2”列中的“%1”不是长度</translation>
    </message>
    <message>
        <source>Above less below</source>
        <translation>上方减下方</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angle between the planes</source>
        <translation>两平面的夹角</translation>
    </message>
    <message>
        <source>Angle in plan</source>
        <translation>水平投影角度</translation>
    </message>
    <message>
        <source>Arc (yaw mark)</source>
        <translation>圆弧（侧滑印痕）</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Area in plan</source>
        <translation>水平投影面积</translation>
    </message>
    <message>
        <source>Area of the damage in plan</source>
        <translation>损坏部分的水平投影面积</translation>
    </message>
    <message>
        <source>Area of the outline in plan</source>
        <translation>轮廓的水平投影面积</translation>
    </message>
    <message>
        <source>At how many places along the line the height is found, as the median of the points there.</source>
        <translation>沿线在多少处求取高度，取该处各点的中位数。</translation>
    </message>
    <message>
        <source>Base scan</source>
        <translation>基准扫描</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>弦长</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Critical speed, radius by chord</source>
        <translation>临界速度（半径由弦长求得）</translation>
    </message>
    <message>
        <source>Critical speed, radius by fit</source>
        <translation>临界速度（半径由拟合求得）</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Crossfall of the road towards the inside of the bend.</source>
        <translation>路面向弯道内侧的横坡。</translation>
    </message>
    <message>
        <source>Crush profile</source>
        <translation>变形断面</translation>
    </message>
    <message>
        <source>Damage width L</source>
        <translation>损坏宽度 L</translation>
    </message>
    <message>
        <source>Deepest below the line between its ends</source>
        <translation>两端连线之下最深处</translation>
    </message>
    <message>
        <source>Depth of the area's centroid</source>
        <translation>面积形心的深度</translation>
    </message>
    <message>
        <source>Depths C1 to C6 at evenly spaced stations of the damage, from the undamaged outline.</source>
        <translation>从未损坏轮廓量起，损坏部分各等距测点的深度 C1 至 C6。</translation>
    </message>
    <message>
        <source>Depths count from the straight line between the undamaged ends. For a bulged side trace the whole outline last, and set in the panel how many points it has.</source>
        <translation>深度从两个未损坏端点之间的直线量起。若该侧原本外凸，请在最后沿完好的轮廓单击，并在面板中设置其点数。</translation>
    </message>
    <message>
        <source>Diagonal of the box</source>
        <translation>长方体的对角线</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance between the planes</source>
        <translation>两平面的距离</translation>
    </message>
    <message>
        <source>Distance from the plane</source>
        <translation>到平面的距离</translation>
    </message>
    <message>
        <source>Drag factor</source>
        <translation>附着系数</translation>
    </message>
    <message>
        <source>Drag factor, half range</source>
        <translation>附着系数的半宽</translation>
    </message>
    <message>
        <source>Friction of tyre and road, in units of gravity, for a speed; 0: no speed is given.</source>
        <translation>轮胎与路面的附着系数（摩擦力与重力之比），用于求速度；0：不求速度。</translation>
    </message>
    <message>
        <source>Half width of the section</source>
        <translation>断面的半宽</translation>
    </message>
    <message>
        <source>Height difference</source>
        <translation>高差</translation>
    </message>
    <message>
        <source>Height difference of its ends</source>
        <translation>其两端的高差</translation>
    </message>
    <message>
        <source>Height difference of the ends</source>
        <translation>两端的高差</translation>
    </message>
    <message>
        <source>Height of the box</source>
        <translation>长方体的高度</translation>
    </message>
    <message>
        <source>Height of the centre</source>
        <translation>圆心的高程</translation>
    </message>
    <message>
        <source>Height of the plane measured in</source>
        <translation>测量所在平面的高程</translation>
    </message>
    <message>
        <source>Highest above the line between its ends</source>
        <translation>两端连线之上最高处</translation>
    </message>
    <message>
        <source>Horizontal distance</source>
        <translation>水平距离</translation>
    </message>
    <message>
        <source>Horizontal length</source>
        <translation>水平长度</translation>
    </message>
    <message>
        <source>Horizontal part</source>
        <translation>水平分量</translation>
    </message>
    <message>
        <source>How far inside of the mark the centre of mass went: half the track width for an outer tyre.</source>
        <translation>质心轨迹位于印痕内侧多远：对外侧轮胎为轮距的一半。</translation>
    </message>
    <message>
        <source>How many evenly spaced depths are given: 6 for C1 to C6.</source>
        <translation>给出多少个等距的深度：6 个即 C1 至 C6。</translation>
    </message>
    <message>
        <source>How many picks at the end trace the undamaged outline, on the other side of the vehicle or on a scan of another, from the end that matches the first undamaged one; it is laid onto the damaged side from end to end. 0: the outline is the straight line between the two undamaged ends.</source>
        <translation>最后多少个点取自未损坏轮廓，可在车辆的另一侧，也可在另一车辆的扫描上，从与第一个未损坏端点对应的一端开始；轮廓从一端到另一端套合到损坏侧。0：轮廓为两个未损坏端点之间的直线。</translation>
    </message>
    <message>
        <source>How many picks, from the first on, lie on the first plane; the others lie on the second.</source>
        <translation>从第一个点选起，有多少个位于第一个平面上；其余位于第二个平面上。</translation>
    </message>
    <message>
        <source>Largest crush</source>
        <translation>最大变形量</translation>
    </message>
    <message>
        <source>Length along the line</source>
        <translation>沿线长度</translation>
    </message>
    <message>
        <source>Length along the surface</source>
        <translation>沿表面长度</translation>
    </message>
    <message>
        <source>Length of the arc</source>
        <translation>圆弧的长度</translation>
    </message>
    <message>
        <source>Length of the box</source>
        <translation>长方体的长度</translation>
    </message>
    <message>
        <source>Length, width and height of the smallest upright box round the points.</source>
        <translation>包围各点的最小直立长方体的长、宽、高。</translation>
    </message>
    <message>
        <source>Level base</source>
        <translation>水平基准面</translation>
    </message>
    <message>
        <source>Level length of the section</source>
        <translation>断面的水平长度</translation>
    </message>
    <message>
        <source>Mark to centre of mass</source>
        <translation>印痕到质心的距离</translation>
    </message>
    <message>
        <source>Mean crush</source>
        <translation>平均变形量</translation>
    </message>
    <message>
        <source>Mean grade</source>
        <translation>平均坡度</translation>
    </message>
    <message>
        <source>Middle of the damage from the middle of the base line D</source>
        <translation>损坏部分中点到基准线中点的距离 D</translation>
    </message>
    <message>
        <source>Middle ordinate</source>
        <translation>弦中矢高</translation>
    </message>
    <message>
        <source>Number in the list of scans, from 1, of the one whose surface is the base; 0: the plane.</source>
        <translation>在扫描列表中从 1 起的编号，以该扫描的表面为基准面；0：以平面为基准面。</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>周长</translation>
    </message>
    <message>
        <source>Places along the section</source>
        <translation>断面上的测点数</translation>
    </message>
    <message>
        <source>Plane to plane</source>
        <translation>平面到平面</translation>
    </message>
    <message>
        <source>Point to plane</source>
        <translation>点到平面</translation>
    </message>
    <message>
        <source>Points of the first plane</source>
        <translation>第一个平面的点数</translation>
    </message>
    <message>
        <source>Points of the undamaged outline</source>
        <translation>未损坏轮廓的点数</translation>
    </message>
    <message>
        <source>Points within this distance of the line, in plan, belong to the section.</source>
        <translation>水平投影上离该线不超过此距离的点属于断面。</translation>
    </message>
    <message>
        <source>Polyline (skid mark)</source>
        <translation>折线（制动印痕）</translation>
    </message>
    <message>
        <source>Radius by chord and middle ordinate</source>
        <translation>由弦长和弦中矢高求得的半径</translation>
    </message>
    <message>
        <source>Radius by fit</source>
        <translation>拟合半径</translation>
    </message>
    <message>
        <source>Reference value</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Share of the outline that has points</source>
        <translation>轮廓内有点部分的比例</translation>
    </message>
    <message>
        <source>Share of the section that has points</source>
        <translation>断面上有点部分的比例</translation>
    </message>
    <message>
        <source>Side of the square cells whose mean heights are summed; automatic: twice the points' spacing.</source>
        <translation>正方形单元的边长，对各单元的平均高度求和；自动：点间距的两倍。</translation>
    </message>
    <message>
        <source>Speed to leave such a skid mark</source>
        <translation>留下此制动印痕所需的速度</translation>
    </message>
    <message>
        <source>Spread of the heights</source>
        <translation>高程的离散度</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>测点数</translation>
    </message>
    <message>
        <source>Straight from end to end</source>
        <translation>两端直线距离</translation>
    </message>
    <message>
        <source>Superelevation</source>
        <translation>超高</translation>
    </message>
    <message>
        <source>The angle at the second of three points.</source>
        <translation>三个点中第二个点处的角度。</translation>
    </message>
    <message>
        <source>The area within a closed outline.</source>
        <translation>闭合轮廓之内的面积。</translation>
    </message>
    <message>
        <source>The base is level at the height of the lowest corner, instead of the plane fitted to all corners.</source>
        <translation>基准面取最低角点高程处的水平面，而不取由所有角点拟合的平面。</translation>
    </message>
    <message>
        <source>The diameter of a circle fitted to points of its rim.</source>
        <translation>由圆周上各点拟合的圆的直径。</translation>
    </message>
    <message>
        <source>The distance between two planes and the angle between them.</source>
        <translation>两个平面之间的距离及其夹角。</translation>
    </message>
    <message>
        <source>The distance of the first point from the plane through the others.</source>
        <translation>第一个点到通过其余各点的平面的距离。</translation>
    </message>
    <message>
        <source>The drag factor is known to lie within plus and minus this of the value given.</source>
        <translation>已知附着系数位于给定值加减此值的范围之内。</translation>
    </message>
    <message>
        <source>The heights of the cloud along a line in plan, and their dimensions.</source>
        <translation>点云沿一条水平投影线的高程及其尺寸。</translation>
    </message>
    <message>
        <source>The last %1 points trace the undamaged outline, from its first end to the second, here or on a scan of another vehicle.</source>
        <translation>最后 %1 个点取自未损坏轮廓，从第一端到第二端，可在此处，也可在另一车辆的扫描上。</translation>
    </message>
    <message>
        <source>The length along a line through several points.</source>
        <translation>沿通过若干点的折线的长度。</translation>
    </message>
    <message>
        <source>The level part of the way between two points.</source>
        <translation>两点之间路径的水平分量。</translation>
    </message>
    <message>
        <source>The radius of a mark in plan: by chord and middle ordinate, and by a circle fitted to all points.</source>
        <translation>印痕在水平投影上的半径：由弦长和弦中矢高求得，以及由所有点拟合的圆求得。</translation>
    </message>
    <message>
        <source>The space between the cloud and a base plane within an outline.</source>
        <translation>轮廓之内点云与基准面之间的空间。</translation>
    </message>
    <message>
        <source>The straight distance between two points.</source>
        <translation>两点之间的直线距离。</translation>
    </message>
    <message>
        <source>The upright part of the way between two points.</source>
        <translation>两点之间路径的竖直分量。</translation>
    </message>
    <message>
        <source>Tilt of its plane to the level</source>
        <translation>其平面与水平面的倾角</translation>
    </message>
    <message>
        <source>Tilt of the plane to the level</source>
        <translation>平面与水平面的倾角</translation>
    </message>
    <message>
        <source>Vertical part</source>
        <translation>竖直分量</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Volume above the base</source>
        <translation>基准面以上的体积</translation>
    </message>
    <message>
        <source>Volume below the base</source>
        <translation>基准面以下的体积</translation>
    </message>
    <message>
        <source>Volume of the box</source>
        <translation>长方体的体积</translation>
    </message>
    <message>
        <source>What another method says, to compare with; 0 where there is none.</source>
        <translation>用于对比的其他方法的测值；没有时为 0。</translation>
    </message>
    <message>
        <source>Width of the box</source>
        <translation>长方体的宽度</translation>
    </message>
    <message>
        <source>a circle needs three points</source>
        <translation>圆需要三个点</translation>
    </message>
    <message>
        <source>a corner of the outline</source>
        <translation>轮廓的角点</translation>
    </message>
    <message>
        <source>a leg of the angle has no length</source>
        <translation>角的一条边没有长度</translation>
    </message>
    <message>
        <source>a plane needs three points</source>
        <translation>平面需要三个点</translation>
    </message>
    <message>
        <source>a point of the first plane</source>
        <translation>第一个平面上的点</translation>
    </message>
    <message>
        <source>a point of the plane</source>
        <translation>平面上的点</translation>
    </message>
    <message>
        <source>a point of the rim</source>
        <translation>圆周上的点</translation>
    </message>
    <message>
        <source>a point of the second plane</source>
        <translation>第二个平面上的点</translation>
    </message>
    <message>
        <source>a point that the box is to reach</source>
        <translation>长方体应到达的点</translation>
    </message>
    <message>
        <source>an end</source>
        <translation>端点</translation>
    </message>
    <message>
        <source>an end of the first leg</source>
        <translation>第一条边的端点</translation>
    </message>
    <message>
        <source>an end of the second leg</source>
        <translation>第二条边的端点</translation>
    </message>
    <message>
        <source>column %1 is called '%2'</source>
        <translation>第 %1 列名为“%2”</translation>
    </message>
    <message>
        <source>departure from a circle</source>
        <translation>与圆的偏离</translation>
    </message>
    <message>
        <source>drag factor</source>
        <translation>附着系数</translation>
    </message>
    <message>
        <source>expected %1 at most</source>
        <translation>至多应为 %1 列</translation>
    </message>
    <message>
        <source>expected %1, as in the first row</source>
        <translation>应为 %1 个，与第一行相同</translation>
    </message>
    <message>
        <source>expected ',' between them, and '.' in numbers</source>
        <translation>列之间应为“,”，数字中应为“.”</translation>
    </message>
    <message>
        <source>expected a name</source>
        <translation>应为名称</translation>
    </message>
    <message>
        <source>expected metres such as 4.93, or nothing where it was not measured</source>
        <translation>应为米数，例如 4.93；未测量处留空</translation>
    </message>
    <message>
        <source>expected the taped length in metres, above 0</source>
        <translation>应为卷尺测得的长度，以米为单位，大于 0</translation>
    </message>
    <message>
        <source>fitted features</source>
        <translation>拟合的特征</translation>
    </message>
    <message>
        <source>height of the base</source>
        <translation>基准面的高程</translation>
    </message>
    <message>
        <source>no %1 was found round the pick</source>
        <translation>点选处附近未找到%1</translation>
    </message>
    <message>
        <source>no point of the cloud lies within the outline</source>
        <translation>轮廓之内没有点云的点</translation>
    </message>
    <message>
        <source>pick nearer to it, or choose another feature</source>
        <translation>请在更靠近它处点选，或选择其他特征</translation>
    </message>
    <message>
        <source>point spacing</source>
        <translation>点间距</translation>
    </message>
    <message>
        <source>registration of %1</source>
        <translation>%1 的配准</translation>
    </message>
    <message>
        <source>repeat %1: %2</source>
        <translation>第 %1 次测量：%2</translation>
    </message>
    <message>
        <source>scatter of the cloud</source>
        <translation>点云的离散</translation>
    </message>
    <message>
        <source>sensor noise</source>
        <translation>传感器噪声</translation>
    </message>
    <message>
        <source>the arc ends where it begins</source>
        <translation>圆弧的终点与起点重合</translation>
    </message>
    <message>
        <source>the cell in the column 'object' is empty</source>
        <translation>“object”列的单元格为空</translation>
    </message>
    <message>
        <source>the column '%1' stands there twice</source>
        <translation>“%1”列出现了两次</translation>
    </message>
    <message>
        <source>the column 'tape_m' holds no length</source>
        <translation>“tape_m”列中没有长度</translation>
    </message>
    <message>
        <source>the columns are parted by ';'</source>
        <translation>各列以“;”分隔</translation>
    </message>
    <message>
        <source>the damage has fewer than two points</source>
        <translation>损坏部分的点少于两个</translation>
    </message>
    <message>
        <source>the end of the section</source>
        <translation>断面的终点</translation>
    </message>
    <message>
        <source>the first undamaged end</source>
        <translation>第一个未损坏的端点</translation>
    </message>
    <message>
        <source>the next corner of the outline</source>
        <translation>轮廓的下一个角点</translation>
    </message>
    <message>
        <source>the next point</source>
        <translation>下一个点</translation>
    </message>
    <message>
        <source>the next point of the arc</source>
        <translation>圆弧的下一个点</translation>
    </message>
    <message>
        <source>the next point of the damaged surface</source>
        <translation>损坏表面的下一个点</translation>
    </message>
    <message>
        <source>the outline has no area in plan</source>
        <translation>轮廓没有水平投影面积</translation>
    </message>
    <message>
        <source>the outline holds more than 250000 cells; take larger ones</source>
        <translation>轮廓内的单元超过 250000 个；请取较大的单元</translation>
    </message>
    <message>
        <source>the outline stands upright, so nothing is above it</source>
        <translation>轮廓是竖直的，因此其上方没有空间</translation>
    </message>
    <message>
        <source>the outline's ends are one and the same</source>
        <translation>轮廓的两端是同一点</translation>
    </message>
    <message>
        <source>the point</source>
        <translation>该点</translation>
    </message>
    <message>
        <source>the points of the arc lie on one line, or none between its ends</source>
        <translation>圆弧的各点位于一条直线上，或两端之间没有点</translation>
    </message>
    <message>
        <source>the points of the box lie on one line in plan</source>
        <translation>长方体的各点在水平投影上位于一条直线上</translation>
    </message>
    <message>
        <source>the points of the circle are one and the same</source>
        <translation>圆的各点是同一点</translation>
    </message>
    <message>
        <source>the points of the circle lie on one line</source>
        <translation>圆的各点位于一条直线上</translation>
    </message>
    <message>
        <source>the points of the damage lie over one place</source>
        <translation>损坏部分的各点位于同一处之上</translation>
    </message>
    <message>
        <source>the points of the plane lie on one line</source>
        <translation>平面的各点位于一条直线上</translation>
    </message>
    <message>
        <source>the row has %1 cells</source>
        <translation>该行有 %1 个单元格</translation>
    </message>
    <message>
        <source>the scan that is to be the base has no point here</source>
        <translation>作为基准面的扫描在此处没有点</translation>
    </message>
    <message>
        <source>the second plane has fewer than three points</source>
        <translation>第二个平面的点少于三个</translation>
    </message>
    <message>
        <source>the second undamaged end</source>
        <translation>第二个未损坏的端点</translation>
    </message>
    <message>
        <source>the section has no length in plan</source>
        <translation>断面没有水平投影长度</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>the start of the arc</source>
        <translation>圆弧的起点</translation>
    </message>
    <message>
        <source>the start of the damage</source>
        <translation>损坏部分的起点</translation>
    </message>
    <message>
        <source>the start of the section</source>
        <translation>断面的起点</translation>
    </message>
    <message>
        <source>the table has %1 columns</source>
        <translation>该表有 %1 列</translation>
    </message>
    <message>
        <source>the table has no column '%1'</source>
        <translation>该表没有“%1”列</translation>
    </message>
    <message>
        <source>the table has no column of measured lengths</source>
        <translation>该表没有测量长度的列</translation>
    </message>
    <message>
        <source>the table has no row below its first</source>
        <translation>该表第一行以下没有内容</translation>
    </message>
    <message>
        <source>the table is empty</source>
        <translation>该表为空</translation>
    </message>
    <message>
        <source>the undamaged ends are one and the same</source>
        <translation>两个未损坏的端点是同一点</translation>
    </message>
    <message>
        <source>the vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>there are no points round the pick</source>
        <translation>点选处附近没有点</translation>
    </message>
    <message>
        <source>there are no points to fit to</source>
        <translation>没有可供拟合的点</translation>
    </message>
    <message>
        <source>undamaged outline</source>
        <translation>未损坏轮廓</translation>
    </message>
</context>
<context>
    <name>core/pipeline</name>
    <message>
        <source>&quot;registration&quot;: {&quot;target&quot;: ...} names the layer that the others are registered to</source>
        <translation>&quot;registration&quot;: {&quot;target&quot;: ...} 指定其他图层所配准到的图层</translation>
    </message>
    <message>
        <source>%1 as registered, over the global cloud</source>
        <translation>%1：配准后的位置，叠加于全局点云</translation>
    </message>
    <message>
        <source>%1 at its first pose, over the global cloud</source>
        <translation>%1：初始位姿，叠加于全局点云</translation>
    </message>
    <message>
        <source>%1 mm and %2°</source>
        <translation>%1 mm 和 %2°</translation>
    </message>
    <message>
        <source>%1 registered: overlap %2, root mean square distance %3 mm</source>
        <translation>%1 已配准：重叠度 %2，均方根距离 %3 mm</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1, by %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>%1, by %2: %3 %4</source>
        <translation>%1，%2：%3 %4</translation>
    </message>
    <message>
        <source>--every %1 takes every %2th point, --box xmin,ymin,zmin,xmax,ymax,zmax a part; a case says &quot;keep_every&quot; or &quot;box&quot; of a layer</source>
        <translation>--every %1 每 %2 个点取一个，--box xmin,ymin,zmin,xmax,ymax,zmax 取一部分；在案件中用图层的 &quot;keep_every&quot; 或 &quot;box&quot;</translation>
    </message>
    <message>
        <source>; what hangs above is left out</source>
        <translation>；上方悬空部分已略去</translation>
    </message>
    <message>
        <source>Cleaning and thinning the global cloud</source>
        <translation>全局点云的清理与稀释</translation>
    </message>
    <message>
        <source>Drawing the pictures</source>
        <translation>绘制图片</translation>
    </message>
    <message>
        <source>Reading and indexing the clouds</source>
        <translation>读取点云并建立索引</translation>
    </message>
    <message>
        <source>Registering the scans</source>
        <translation>配准扫描</translation>
    </message>
    <message>
        <source>Setting the report</source>
        <translation>编排报告</translation>
    </message>
    <message>
        <source>Taking recorded aims</source>
        <translation>采用记录的点选</translation>
    </message>
    <message>
        <source>The measured objects, coloured by scan</source>
        <translation>所测对象，按扫描着色</translation>
    </message>
    <message>
        <source>The site from above, coloured by height</source>
        <translation>现场俯视图，按高程着色</translation>
    </message>
    <message>
        <source>The site, coloured by height</source>
        <translation>现场全景，按高程着色</translation>
    </message>
    <message>
        <source>Writing the fused cloud and the tables</source>
        <translation>写出融合点云和表格</translation>
    </message>
    <message>
        <source>Writing the manifest</source>
        <translation>写出清单</translation>
    </message>
    <message>
        <source>a fused cloud holds 65535 layers at most</source>
        <translation>融合点云至多容纳 65535 个图层</translation>
    </message>
    <message>
        <source>a result would replace %1, an input</source>
        <translation>结果将会覆盖输入 %1</translation>
    </message>
    <message>
        <source>adjusted together with its neighbours (%1), which moved it by %2</source>
        <translation>已与相邻图层（%1）一并平差，由此移动了 %2</translation>
    </message>
    <message>
        <source>aims</source>
        <translation>点选</translation>
    </message>
    <message>
        <source>all attributes of its points are wanted, beside what is held of them; expected: more free memory, or a layer that is thinned or a part (&quot;keep_every&quot;, &quot;box&quot; in the case)</source>
        <translation>除已保留的以外，还需要其点的全部属性；应为：更多可用内存，或经过稀释或只取一部分的图层（案件中的 &quot;keep_every&quot;、&quot;box&quot;）</translation>
    </message>
    <message>
        <source>at 1:%1 in print</source>
        <translation>打印比例 1:%1</translation>
    </message>
    <message>
        <source>check that the clouds show the same place, and give a nearer first pose</source>
        <translation>请检查各点云是否表示同一地点，并给出更接近的初始位姿</translation>
    </message>
    <message>
        <source>check the picked pairs, the pose and the unit</source>
        <translation>请检查点对、位姿和单位</translation>
    </message>
    <message>
        <source>first pose from %1 picked pairs, each good to %2 mm (residuals %3)</source>
        <translation>由 %1 个点对得到初始位姿，每对精度为 %2 mm（残差 %3）</translation>
    </message>
    <message>
        <source>give a nearer first pose, or a scan between them</source>
        <translation>请给出更接近的初始位姿，或其间的另一个扫描</translation>
    </message>
    <message>
        <source>give picked pairs as the first pose</source>
        <translation>请给出点对作为初始位姿</translation>
    </message>
    <message>
        <source>index of %1</source>
        <translation>%1 的索引</translation>
    </message>
    <message>
        <source>inputs are only ever read; expected: another folder</source>
        <translation>输入只会被读取；应为：另一个文件夹</translation>
    </message>
    <message>
        <source>it contradicts the layers' own registrations to the target; which is right cannot be told</source>
        <translation>它与图层自身到目标的配准相矛盾；无法判断哪一个正确</translation>
    </message>
    <message>
        <source>it must not change while it is worked with; read it again</source>
        <translation>使用期间文件不得改变；请重新读取</translation>
    </message>
    <message>
        <source>its first pose leads to &quot;%1&quot;, which has no place in the scene</source>
        <translation>其初始位姿依赖“%1”，而后者在现场中没有位置</translation>
    </message>
    <message>
        <source>layer %1</source>
        <translation>图层 %1</translation>
    </message>
    <message>
        <source>layer %1, %2</source>
        <translation>图层 %1，%2</translation>
    </message>
    <message>
        <source>layer names</source>
        <translation>图层名称</translation>
    </message>
    <message>
        <source>no layer that has its place overlaps it</source>
        <translation>没有位置已定的图层与它重叠</translation>
    </message>
    <message>
        <source>nor can it be registered to %1</source>
        <translation>也不能配准到 %1</translation>
    </message>
    <message>
        <source>not prepared</source>
        <translation>未准备好</translation>
    </message>
    <message>
        <source>one of the layers' ids</source>
        <translation>各图层 id 之一</translation>
    </message>
    <message>
        <source>one of them must lead to the target</source>
        <translation>其中之一必须通向目标</translation>
    </message>
    <message>
        <source>part of layer %1</source>
        <translation>图层 %1 的一部分</translation>
    </message>
    <message>
        <source>picks of %1</source>
        <translation>%1 的点对</translation>
    </message>
    <message>
        <source>picture %1</source>
        <translation>图片 %1</translation>
    </message>
    <message>
        <source>points of photogrammetry err together, which no fit averages out</source>
        <translation>摄影测量的点误差相关，拟合无法将其平均掉</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>register that layer, too</source>
        <translation>请把该图层也配准</translation>
    </message>
    <message>
        <source>the case gives the unit %1, but it looks like %2: %3</source>
        <translation>案件给出的单位是 %1，但看起来是 %2：%3</translation>
    </message>
    <message>
        <source>the case has no layer of this name</source>
        <translation>案件中没有此名称的图层</translation>
    </message>
    <message>
        <source>the case has no layers</source>
        <translation>案件中没有图层</translation>
    </message>
    <message>
        <source>the case names no layer that the others are registered to</source>
        <translation>案件没有指定其他图层所配准到的图层</translation>
    </message>
    <message>
        <source>the file has changed since its points were read</source>
        <translation>读取点之后文件发生了改变</translation>
    </message>
    <message>
        <source>the first pose puts the scan where the target has no points</source>
        <translation>初始位姿把扫描放到了目标没有点的地方</translation>
    </message>
    <message>
        <source>the first poses lead from layer to layer in a circle</source>
        <translation>各图层的初始位姿相互循环依赖</translation>
    </message>
    <message>
        <source>the fit moved the scan %1 m from a first pose that is known much better than that</source>
        <translation>拟合把扫描从初始位姿移动了 %1 m，而该初始位姿的精度远好于此</translation>
    </message>
    <message>
        <source>the layer has no points</source>
        <translation>该图层没有点</translation>
    </message>
    <message>
        <source>the layer is not loaded</source>
        <translation>图层未载入</translation>
    </message>
    <message>
        <source>the loop %1 fails to close by %2, more than its registrations allow</source>
        <translation>闭合环 %1 的闭合差为 %2，超出其各配准所允许的范围</translation>
    </message>
    <message>
        <source>the registration cannot be relied on: %1</source>
        <translation>该配准不可信赖：%1</translation>
    </message>
    <message>
        <source>the registration of %1 is doubtful</source>
        <translation>%1 的配准存疑</translation>
    </message>
    <message>
        <source>the target &quot;%1&quot; is not a layer of the case</source>
        <translation>目标“%1”不是案件中的图层</translation>
    </message>
    <message>
        <source>the target cannot be registered to itself</source>
        <translation>目标不能配准到自身</translation>
    </message>
    <message>
        <source>this format is read whole before a part is taken; expected: more memory, or the file as LAS or LAZ</source>
        <translation>此格式须先整体读取才能取其一部分；应为：更多内存，或 LAS 或 LAZ 格式的文件</translation>
    </message>
    <message>
        <source>unit recognised as %1: %2</source>
        <translation>识别出单位为 %1：%2</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>警告：%1</translation>
    </message>
</context>
<context>
    <name>core/registration</name>
    <message>
        <source>%1 field 'pose'</source>
        <translation>%1 字段“pose”</translation>
    </message>
    <message>
        <source>%1 has no effect with the method %2</source>
        <translation>%1 对方法 %2 不起作用</translation>
    </message>
    <message>
        <source>%1 is not a number: '%2'</source>
        <translation>%1 不是数：“%2”</translation>
    </message>
    <message>
        <source>%1 line 1</source>
        <translation>%1 第 1 行</translation>
    </message>
    <message>
        <source>%1 of the surface agrees, every direction is held</source>
        <translation>%1 的表面吻合，各个方向均受约束</translation>
    </message>
    <message>
        <source>%1 of the surface agrees, every direction is held and %2 of %3 perturbed starts came back to this pose</source>
        <translation>%1 的表面吻合，各个方向均受约束，且 %3 次扰动重启中有 %2 次回到此位姿</translation>
    </message>
    <message>
        <source>%1, although its file says %2</source>
        <translation>%1，而其文件说明单位为%2</translation>
    </message>
    <message>
        <source>%1: as good</source>
        <translation>%1：同样好</translation>
    </message>
    <message>
        <source>%1: worse</source>
        <translation>%1：较差</translation>
    </message>
    <message>
        <source>A cell is flat when its smallest eigenvalue is at most this share of their sum.</source>
        <translation>最小特征值不超过三个特征值之和的这一比例时，单元为平面。</translation>
    </message>
    <message>
        <source>A direction counts as free, and the result as doubtful, when the pose's standard deviation along it is larger.</source>
        <translation>位姿沿某方向的标准差大于此值时，该方向视为自由，结果存疑。</translation>
    </message>
    <message>
        <source>A registration has failed when of neither cloud so large a share lies on the other.</source>
        <translation>两个点云中都没有这么大的比例落在另一个上时，配准失败。</translation>
    </message>
    <message>
        <source>A registration has failed when that share is larger than this.</source>
        <translation>该比例大于此值时，配准失败。</translation>
    </message>
    <message>
        <source>A registration has failed when, in some direction, a smaller share of the surface that could hold it agrees.</source>
        <translation>在某个方向上，能约束位姿的表面中吻合的比例小于此值时，配准失败。</translation>
    </message>
    <message>
        <source>A registration is doubtful when a scanner has seen through the place of a larger share of the surface that the pose puts before it.</source>
        <translation>位姿放在扫描仪前方的表面中，其所在处已被扫描仪看穿的比例大于此值时，配准存疑。</translation>
    </message>
    <message>
        <source>A registration is doubtful when that share is smaller than this.</source>
        <translation>该比例小于此值时，配准存疑。</translation>
    </message>
    <message>
        <source>A registration is doubtful when the 95 % half axis of its rotation is larger.</source>
        <translation>旋转的 95 % 半轴大于此值时，配准存疑。</translation>
    </message>
    <message>
        <source>A registration is doubtful when the longest half axis of the 95 % ellipsoid of the source's middle is longer.</source>
        <translation>源中心的 95 % 椭球最长半轴大于此值时，配准存疑。</translation>
    </message>
    <message>
        <source>A second place that agrees with the target as well as the best but for this share makes the first pose ambiguous.</source>
        <translation>第二处位置与目标的吻合程度和最佳者之差不超过此比例时，初始位姿不唯一。</translation>
    </message>
    <message>
        <source>A voxel size is done when the Newton step is shorter than this.</source>
        <translation>牛顿步长小于此值时，该级体素尺寸结束。</translation>
    </message>
    <message>
        <source>A voxel size is done when the score's gradient is shorter than this.</source>
        <translation>得分的梯度小于此值时，该级体素尺寸结束。</translation>
    </message>
    <message>
        <source>Aerial layers besides the target are registered, too, from where they lie: strips of one flight. Without it they are compared as they come.</source>
        <translation>目标以外的航测图层也从其所在位置进行配准：同一次飞行的航带。否则按原样进行比较。</translation>
    </message>
    <message>
        <source>Bound of the first Newton step at each voxel size, never above the voxel; automatic: a quarter of the voxel, as published 0.1 m.</source>
        <translation>每级体素尺寸中第一个牛顿步长的界限，不超过体素；自动：体素的四分之一，按已发表方法为 0.1 m。</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Edge of the first NDT cell v_0; automatic: 4 m, less for a source smaller than that.</source>
        <translation>第一级 NDT 单元 v_0 的边长；自动：4 m，源较小时取更小值。</translation>
    </message>
    <message>
        <source>Edge of the smallest NDT cell v_n; automatic: where most of the target's cells are flat (ndt and icp: 1 m).</source>
        <translation>最小 NDT 单元 v_n 的边长；自动：目标的单元大多为平面时的尺寸（ndt 和 icp：1 m）。</translation>
    </message>
    <message>
        <source>Error of the first pose</source>
        <translation>初始位姿误差</translation>
    </message>
    <message>
        <source>First trust radius</source>
        <translation>初始信赖域半径</translation>
    </message>
    <message>
        <source>Flatness limit</source>
        <translation>平面度界限</translation>
    </message>
    <message>
        <source>Free direction</source>
        <translation>自由方向判据</translation>
    </message>
    <message>
        <source>Gradient limit</source>
        <translation>梯度界限</translation>
    </message>
    <message>
        <source>How far the first pose is off (standard deviation): where it is known the first NDT cell needs to be no larger; automatic: the residual of picked pairs, unknown for other first poses.</source>
        <translation>初始位姿的偏差（标准差）：已知时第一级 NDT 单元不必更大；自动：取点对的残差，其他初始位姿为未知。</translation>
    </message>
    <message>
        <source>How often the result is tried again from a perturbed start; most must come back to it.</source>
        <translation>从扰动起点对结果重新计算的次数；多数必须回到原结果。</translation>
    </message>
    <message>
        <source>How the source is registered: improved NDT, or classic NDT or point-to-plane ICP to compare with.</source>
        <translation>源的配准方法：改进 NDT，或用于对比的经典 NDT 或点到面 ICP。</translation>
    </message>
    <message>
        <source>Improved NDT as improved here, or as published: classic cells of one size, starting at 1 m.</source>
        <translation>本软件改进的改进 NDT，或按已发表方法：单一尺寸的经典单元，从 1 m 开始。</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>Iterations at one voxel size after which it counts as not converged.</source>
        <translation>一级体素尺寸的迭代次数，超过则视为未收敛。</translation>
    </message>
    <message>
        <source>Largest voxel</source>
        <translation>最大体素</translation>
    </message>
    <message>
        <source>Layers besides the target are registered to each other as well where at least this share of the smaller one is expected to lie on the other.</source>
        <translation>目标以外的图层，若其中较小者预计至少有此比例落在另一个上，则也相互配准。</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>最小重叠度</translation>
    </message>
    <message>
        <source>Least overlap of a pair</source>
        <translation>图层对的最小重叠度</translation>
    </message>
    <message>
        <source>Margin between first poses</source>
        <translation>初始位姿之间的裕度</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>One source point per voxel of this edge; automatic: the smallest voxel, half of it as published and for ndt (ICP: an eighth). A sparse source is thinned further, to some four points per voxel.</source>
        <translation>每个此边长的体素取一个源点；自动：最小体素，按已发表方法及 ndt 取其一半（ICP：八分之一）。稀疏的源会进一步稀释到每个体素约四个点。</translation>
    </message>
    <message>
        <source>Outlier ratio</source>
        <translation>离群点比例</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Range noise of the target</source>
        <translation>目标的测距噪声</translation>
    </message>
    <message>
        <source>Range noise of the target taken as %1 mm</source>
        <translation>目标的测距噪声取为 %1 mm</translation>
    </message>
    <message>
        <source>Register aerial strips</source>
        <translation>配准航带</translation>
    </message>
    <message>
        <source>Restarts</source>
        <translation>重启次数</translation>
    </message>
    <message>
        <source>Seen through of a doubt</source>
        <translation>存疑判据：看穿比例</translation>
    </message>
    <message>
        <source>Seen through of a failure</source>
        <translation>失败判据：看穿比例</translation>
    </message>
    <message>
        <source>Share rho of source points that no target cell explains.</source>
        <translation>没有目标单元能解释的源点所占比例 rho。</translation>
    </message>
    <message>
        <source>Smallest voxel</source>
        <translation>最小体素</translation>
    </message>
    <message>
        <source>Smallest voxel %1 m, where %2 % of the target's cells are flat</source>
        <translation>最小体素 %1 m，此时目标单元的 %2 % 为平面</translation>
    </message>
    <message>
        <source>Standard deviation of the target's ranges, taken off before a cell's flatness is judged; automatic: the thickness of the target's flattest quarter where the error of the first pose is known, else 0.</source>
        <translation>目标测距的标准差，在判断单元平面度之前扣除；自动：初始位姿误差已知时取目标最平的四分之一的厚度，否则为 0。</translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation>步长界限</translation>
    </message>
    <message>
        <source>Support of a doubt</source>
        <translation>存疑判据：支持度</translation>
    </message>
    <message>
        <source>Support of a failure</source>
        <translation>失败判据：支持度</translation>
    </message>
    <message>
        <source>The file of the source says that it is in %1</source>
        <translation>源文件说明其单位为%1</translation>
    </message>
    <message>
        <source>The least lambda that is added to the Hessian's diagonal.</source>
        <translation>加到海森矩阵对角线上的最小 lambda。</translation>
    </message>
    <message>
        <source>The picked points are %1 times as far apart in the target as in the source, so the source is in %2</source>
        <translation>所选点在目标中的间距是在源中的 %1 倍，因此源的单位为%2</translation>
    </message>
    <message>
        <source>The picked points are %1 times as far apart in the target as in the source, so the source is in %2; the ratio fits no unit well, check the pairs</source>
        <translation>所选点在目标中的间距是在源中的 %1 倍，因此源的单位为%2；该比值与任何单位都不甚相符，请检查点对</translation>
    </message>
    <message>
        <source>The source is %1 units across with a point every %2, the target %3 m with a point every %4 m, so the source is taken to be in %5</source>
        <translation>源的跨度为 %1 个单位，每 %2 有一个点；目标的跨度为 %3 m，每 %4 m 有一个点；因此认为源的单位为%5</translation>
    </message>
    <message>
        <source>Thinning of the source</source>
        <translation>源点云稀释</translation>
    </message>
    <message>
        <source>Uncertain turn of a doubt</source>
        <translation>存疑判据：转角不确定度</translation>
    </message>
    <message>
        <source>Uncertainty of a doubt</source>
        <translation>存疑判据：不确定度</translation>
    </message>
    <message>
        <source>Voxel of the first pose's search</source>
        <translation>初始位姿搜索的体素</translation>
    </message>
    <message>
        <source>What the search for a first pose thins both clouds to; automatic: a fortieth of the source's radius, more where the clouds are coarse or noisy.</source>
        <translation>搜索初始位姿时两个点云稀释到的尺寸；自动：源半径的四十分之一，点云粗疏或噪声大时取更大值。</translation>
    </message>
    <message>
        <source>a first pose needs three corresponding pairs, there are %1</source>
        <translation>初始位姿需要三个对应点对，现有 %1 个</translation>
    </message>
    <message>
        <source>a larger voxel or leaf is needed</source>
        <translation>需要更大的体素或稀释尺寸</translation>
    </message>
    <message>
        <source>a pose %1 away fits as well</source>
        <translation>相距 %1 的另一位姿吻合程度相同</translation>
    </message>
    <message>
        <source>a pose %1 away fits, too, and of its surface a scanner has seen through %2 % only, of this one's %3 %</source>
        <translation>相距 %1 的另一位姿也吻合，其表面只有 %2 % 被扫描仪看穿，而此位姿为 %3 %</translation>
    </message>
    <message>
        <source>a scanner has seen through the place of %1 % of the surface that this pose puts before it</source>
        <translation>此位姿放在扫描仪前方的表面有 %1 % 的所在处已被扫描仪看穿</translation>
    </message>
    <message>
        <source>another start led to a pose %1 away that fits better</source>
        <translation>另一起点得到了相距 %1 且吻合更好的位姿</translation>
    </message>
    <message>
        <source>are two rows in another order, or is the unit of the source another one?</source>
        <translation>是否有两行顺序颠倒，或源的单位不同？</translation>
    </message>
    <message>
        <source>at %1, %2, %3 (score %4, %5 % of the scan met)</source>
        <translation>位于 %1, %2, %3（得分 %4，扫描的 %5 % 相遇）</translation>
    </message>
    <message>
        <source>at %1, %2, %3 (score %4, shapes differ by %5 mm at most, %6 % of the scan met)</source>
        <translation>位于 %1, %2, %3（得分 %4，形状相差至多 %5 mm，扫描的 %6 % 相遇）</translation>
    </message>
    <message>
        <source>cells this small cannot be counted across clouds this large</source>
        <translation>点云太大而单元太小，无法计数</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>does not move</source>
        <translation>不移动</translation>
    </message>
    <message>
        <source>expected a 4x4 matrix row by row</source>
        <translation>应为逐行排列的 4x4 矩阵</translation>
    </message>
    <message>
        <source>expected a decimal number with '.', up to 1e10</source>
        <translation>应为以“.”为小数点的十进制数，不超过 1e10</translation>
    </message>
    <message>
        <source>expected a file of corresponding points, target then source</source>
        <translation>应为对应点文件，先目标后源</translation>
    </message>
    <message>
        <source>expected metres per unit of the source, 0.001 for millimetres</source>
        <translation>应为源的每单位米数，毫米为 0.001</translation>
    </message>
    <message>
        <source>expected the six numbers tx,ty,tz,sx,sy,sz</source>
        <translation>应为六个数 tx,ty,tz,sx,sy,sz</translation>
    </message>
    <message>
        <source>expected three rows or more</source>
        <translation>应为三行或更多</translation>
    </message>
    <message>
        <source>expected {&quot;pose&quot;: [16 numbers], &quot;scale&quot;: metres per unit}</source>
        <translation>应为 {&quot;pose&quot;: [16 个数], &quot;scale&quot;: 每单位米数}</translation>
    </message>
    <message>
        <source>few of the surfaces that would hold the pose agree: in one direction %1 (%2 where both clouds have surface)</source>
        <translation>能约束位姿的表面吻合甚少：某一方向上为 %1（两个点云都有表面处为 %2）</translation>
    </message>
    <message>
        <source>first pose</source>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>first pose found %1, with voxels of %2 m, the source in %3</source>
        <translation>找到初始位姿%1，体素 %2 m，源的单位为%3</translation>
    </message>
    <message>
        <source>give a first pose that lays the source on the target (--init)</source>
        <translation>请给出使源落在目标上的初始位姿 (--init)</translation>
    </message>
    <message>
        <source>give picked pairs (.csv) or a pose as the first pose, or the unit</source>
        <translation>请给出点对 (.csv) 或位姿作为初始位姿，或给出单位</translation>
    </message>
    <message>
        <source>icp</source>
        <translation>ICP</translation>
    </message>
    <message>
        <source>improved-ndt</source>
        <translation>改进 NDT</translation>
    </message>
    <message>
        <source>it has not converged and only %1 of the source lies on the target</source>
        <translation>未收敛，且源只有 %1 落在目标上</translation>
    </message>
    <message>
        <source>its covariance is not positive definite</source>
        <translation>其协方差不是正定的</translation>
    </message>
    <message>
        <source>moves up and down</source>
        <translation>上下移动</translation>
    </message>
    <message>
        <source>ndt</source>
        <translation>经典 NDT</translation>
    </message>
    <message>
        <source>no further decrease was predicted</source>
        <translation>预计不会再下降</translation>
    </message>
    <message>
        <source>no place in the target looks like the source</source>
        <translation>目标中没有与源相似的地方</translation>
    </message>
    <message>
        <source>no source point lies in a cell of the target</source>
        <translation>没有源点落在目标的单元中</translation>
    </message>
    <message>
        <source>normal distributions</source>
        <translation>正态分布</translation>
    </message>
    <message>
        <source>number %1 of 'pose' is not a number</source>
        <translation>“pose”的第 %1 个数不是数</translation>
    </message>
    <message>
        <source>only %1 of %2 perturbed starts came back to this pose</source>
        <translation>%2 次扰动重启中只有 %1 次回到此位姿</translation>
    </message>
    <message>
        <source>only %1 of the source lies within %2 of the target</source>
        <translation>源只有 %1 位于目标的 %2 之内</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>已发表方法</translation>
    </message>
    <message>
        <source>pick three points that are well apart and not in a row</source>
        <translation>请选取彼此相距较远且不在一条直线上的三个点</translation>
    </message>
    <message>
        <source>poses that agree</source>
        <translation>相符的位姿</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>质量评定</translation>
    </message>
    <message>
        <source>registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>restarts</source>
        <translation>重启</translation>
    </message>
    <message>
        <source>roughly %1 (%2° from the y axis)</source>
        <translation>大致%1（与 y 轴成 %2°）</translation>
    </message>
    <message>
        <source>search for a first pose</source>
        <translation>搜索初始位姿</translation>
    </message>
    <message>
        <source>shapes that look alike</source>
        <translation>相似的形状</translation>
    </message>
    <message>
        <source>slides at a slope %1</source>
        <translation>沿%1方向斜向滑动</translation>
    </message>
    <message>
        <source>slides level %1</source>
        <translation>沿%1方向水平滑动</translation>
    </message>
    <message>
        <source>the data do not hold the scan: it %1</source>
        <translation>数据未能约束扫描：它%1</translation>
    </message>
    <message>
        <source>the field 'pose' is not a list of 16 numbers</source>
        <translation>字段“pose”不是 16 个数的列表</translation>
    </message>
    <message>
        <source>the field 'scale' is not a number above 0</source>
        <translation>字段“scale”不是大于 0 的数</translation>
    </message>
    <message>
        <source>the fit moved the source %1 m from a first pose that is known much better than that</source>
        <translation>拟合把源从初始位姿移动了 %1 m，而该初始位姿的精度远好于此</translation>
    </message>
    <message>
        <source>the header is not tx,ty,tz,sx,sy,sz</source>
        <translation>表头不是 tx,ty,tz,sx,sy,sz</translation>
    </message>
    <message>
        <source>the limit of iterations was reached, not converged</source>
        <translation>达到迭代次数上限，未收敛</translation>
    </message>
    <message>
        <source>the limit of steps was reached before it settled</source>
        <translation>在稳定之前达到了步数上限</translation>
    </message>
    <message>
        <source>the other pairs contradict it (probability %1)</source>
        <translation>其他配准对与之矛盾（概率 %1）</translation>
    </message>
    <message>
        <source>the other pairs contradict it (probability below 0.000001)</source>
        <translation>其他配准对与之矛盾（概率低于 0.000001）</translation>
    </message>
    <message>
        <source>the picked pairs contradict each other: laid together as well as they can be, pair %1 is %2 m off</source>
        <translation>点对互相矛盾：尽可能使其重合后，第 %1 对仍相差 %2 m</translation>
    </message>
    <message>
        <source>the picked points lie on one line, which leaves a turn open</source>
        <translation>所选点位于一条直线上，使一个转角无法确定</translation>
    </message>
    <message>
        <source>the pose is uncertain by %1 (95 %) where it is held least: it %2</source>
        <translation>位姿在约束最弱处的不确定度为 %1（95 %）：它%2</translation>
    </message>
    <message>
        <source>the pose is uncertain by %1 degrees (95 %) where it is held least: it %2</source>
        <translation>位姿在约束最弱处的不确定度为 %1 度（95 %）：它%2</translation>
    </message>
    <message>
        <source>the registration cannot be relied on</source>
        <translation>该配准不可信赖</translation>
    </message>
    <message>
        <source>the scan fits several places equally well, the data cannot tell them apart</source>
        <translation>扫描在多处吻合程度相同，数据无法加以区分</translation>
    </message>
    <message>
        <source>the score's slope vanished</source>
        <translation>得分的斜率消失</translation>
    </message>
    <message>
        <source>the source has no extent, it cannot be registered</source>
        <translation>源没有范围，无法配准</translation>
    </message>
    <message>
        <source>the source has too few points to be registered</source>
        <translation>源的点太少，无法配准</translation>
    </message>
    <message>
        <source>the source is empty</source>
        <translation>源为空</translation>
    </message>
    <message>
        <source>the step became negligible</source>
        <translation>步长可忽略</translation>
    </message>
    <message>
        <source>the surfaces that would hold the pose disagree: in one direction only %1 of them lie on the other cloud (%2 where both clouds have surface)</source>
        <translation>能约束位姿的表面不一致：某一方向上只有 %1 落在另一点云上（两个点云都有表面处为 %2）</translation>
    </message>
    <message>
        <source>the target has no surface near the source</source>
        <translation>目标在源附近没有表面</translation>
    </message>
    <message>
        <source>the target is empty</source>
        <translation>目标为空</translation>
    </message>
    <message>
        <source>the unit is not certain, metres and millimetres were both tried</source>
        <translation>单位不确定，米和毫米都已尝试</translation>
    </message>
    <message>
        <source>there are %1 cells</source>
        <translation>有 %1 个单元格</translation>
    </message>
    <message>
        <source>there are %1 pairs</source>
        <translation>有 %1 对</translation>
    </message>
    <message>
        <source>there is no field 'pose'</source>
        <translation>没有字段“pose”</translation>
    </message>
    <message>
        <source>tilts about a level axis that runs %1</source>
        <translation>绕%1方向的水平轴倾斜</translation>
    </message>
    <message>
        <source>turns about a sloping axis that runs %1</source>
        <translation>绕%1方向的倾斜轴转动</translation>
    </message>
    <message>
        <source>turns about the vertical axis</source>
        <translation>绕竖直轴转动</translation>
    </message>
</context>
<context>
    <name>core/report</name>
    <message>
        <source>%1 (%2 mm)</source>
        <translation>%1（%2 mm）</translation>
    </message>
    <message>
        <source>%1 (%2 mm, unfiltered %3 mm)</source>
        <translation>%1（%2 mm，未滤波 %3 mm）</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1（%2 / %3）</translation>
    </message>
    <message>
        <source>%1 (%2 with the excluded %3)</source>
        <translation>%1（包含已剔除的 %3 时为 %2）</translation>
    </message>
    <message>
        <source>%1 (all coordinates are in its frame)</source>
        <translation>%1（所有坐标均在其坐标系中）</translation>
    </message>
    <message>
        <source>%1 (hidden)</source>
        <translation>%1（已隐藏）</translation>
    </message>
    <message>
        <source>%1 (root mean square)</source>
        <translation>%1（均方根）</translation>
    </message>
    <message>
        <source>%1 (tape %2 m, standard uncertainty %3 mm)</source>
        <translation>%1（卷尺 %2 m，标准不确定度 %3 mm）</translation>
    </message>
    <message>
        <source>%1 UTC</source>
        <translation>%1 UTC</translation>
    </message>
    <message>
        <source>%1 at the scan's middle, in the worst direction</source>
        <translation>扫描中心处最不利方向上 %1</translation>
    </message>
    <message>
        <source>%1 length</source>
        <translation>%1 个长度</translation>
    </message>
    <message>
        <source>%1 lengths</source>
        <translation>%1 个长度</translation>
    </message>
    <message>
        <source>%1 m along the known poses</source>
        <translation>沿已知位姿 %1 m</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 min 0%2 s</source>
        <translation>%1 min 0%2 s</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm (root mean square of the points that found a counterpart)</source>
        <translation>%1 mm（找到对应点的各点的均方根）</translation>
    </message>
    <message>
        <source>%1 note</source>
        <translation>%1 条说明</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 条说明</translation>
    </message>
    <message>
        <source>%1 object</source>
        <translation>%1 个对象</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 个对象</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 of %2 came back, within %3 and %4°</source>
        <translation>%2中有 %1 次回到原处，相差不超过 %3 和 %4°</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 或更大</translation>
    </message>
    <message>
        <source>%1 perturbed start</source>
        <translation>%1 次扰动重启</translation>
    </message>
    <message>
        <source>%1 perturbed starts</source>
        <translation>%1 次扰动重启</translation>
    </message>
    <message>
        <source>%1 point cloud</source>
        <translation>%1 个点云</translation>
    </message>
    <message>
        <source>%1 point clouds</source>
        <translation>%1 个点云</translation>
    </message>
    <message>
        <source>%1 size</source>
        <translation>%1 级</translation>
    </message>
    <message>
        <source>%1 sizes</source>
        <translation>%1 级</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 步</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 步</translation>
    </message>
    <message>
        <source>%1, %2 a cloud</source>
        <translation>%1，每个点云 %2</translation>
    </message>
    <message>
        <source>%1, %2: cross-section, last repeat</source>
        <translation>%1，%2：断面，最后一次测量</translation>
    </message>
    <message>
        <source>%1, %2: crush in plan, last repeat</source>
        <translation>%1，%2：变形量水平投影，最后一次测量</translation>
    </message>
    <message>
        <source>%1, published</source>
        <translation>%1，已发表</translation>
    </message>
    <message>
        <source>%1. What is missing is not known.</source>
        <translation>%1。缺失的内容不得而知。</translation>
    </message>
    <message>
        <source>%1Excluded, because the relative error lies beyond twice the standard deviation: %2. The RMSE of all objects, these included, stands beside the other.</source>
        <translation>%1因相对误差超出 2 倍标准差而剔除：%2。包含它们在内的全部对象的 RMSE 一并列出。</translation>
    </message>
    <message>
        <source>%1No relative error lies beyond twice their standard deviation, so none was excluded.</source>
        <translation>%1没有相对误差超出其 2 倍标准差，因此未剔除任何对象。</translation>
    </message>
    <message>
        <source>%1The rule would have excluded half of the objects or more, so none was excluded: the errors are systematic, not scattered; their mean is %2 %.</source>
        <translation>%1按规则会剔除一半或更多的对象，因此未剔除任何对象：误差是系统性的而非离散的；其平均值为 %2 %。</translation>
    </message>
    <message>
        <source>%1Where it compares worst, at %2 m, it is %3 % higher. Published: lower at 5 of 6 sizes.</source>
        <translation>%1在最不利处即 %2 m 时高出 %3 %。已发表：6 级中有 5 级较低。</translation>
    </message>
    <message>
        <source>%1Where it compares worst, at %2 m, it is %3 % lower. Published: lower at 5 of 6 sizes.</source>
        <translation>%1在最不利处即 %2 m 时低 %3 %。已发表：6 级中有 5 级较低。</translation>
    </message>
    <message>
        <source>%1With fewer than two objects there is no standard deviation and nothing can be excluded.</source>
        <translation>%1对象少于两个时没有标准差，不能剔除任何对象。</translation>
    </message>
    <message>
        <source>%1° about the worst axis</source>
        <translation>绕最不利轴 %1°</translation>
    </message>
    <message>
        <source>%1° latitude, %2° longitude, %3 m height</source>
        <translation>纬度 %1°，经度 %2°，高程 %3 m</translation>
    </message>
    <message>
        <source>* Set off in the table: excluded from the RMSE, because the relative error lies beyond twice the standard deviation.</source>
        <translation>* 表中突出显示者：因相对误差超出 2 倍标准差，已从 RMSE 中剔除。</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95 % 区间</translation>
    </message>
    <message>
        <source>A file changed: %1.</source>
        <translation>有一个文件发生了改变：%1。</translation>
    </message>
    <message>
        <source>A known distance (a scale bar, or a distance taped at the scene) is measured in the cloud like every other object. It passes when the difference is not larger than the tolerance set for it; only then is the word “verified” used.</source>
        <translation>已知距离（标尺，或在现场用卷尺量得的距离）与其他对象一样在点云中测量。差值不大于为其设定的允差时即为通过；只有这样才使用“已校核”一词。</translation>
    </message>
    <message>
        <source>A length is the straight distance between two points that were picked in the cloud. Each was picked several times anew; the mean of the repeats is the result. Repeat SD is the standard deviation of the repeats. U 95 % is the expanded uncertainty: with a probability of 95 % the true length lies within the mean plus or minus U (how it is found stands under “Uncertainty of the figures”). RE is the relative error against the tape.</source>
        <translation>长度是在点云中点选的两个点之间的直线距离。每个长度均重新点选若干次；结果取各次的平均值。重复标准差是各次测量的标准差。U 95 % 是扩展不确定度：真实长度以 95 % 的概率位于平均值加减 U 的范围之内（求法见“各数值的不确定度”）。RE 是相对于卷尺的相对误差。</translation>
    </message>
    <message>
        <source>Above the plane</source>
        <translation>平面之上</translation>
    </message>
    <message>
        <source>Accuracy against the tape</source>
        <translation>相对于卷尺的准确度</translation>
    </message>
    <message>
        <source>Accuracy of each method against the tape</source>
        <translation>各方法相对于卷尺的准确度</translation>
    </message>
    <message>
        <source>Accuracy report</source>
        <translation>准确度报告</translation>
    </message>
    <message>
        <source>After (mm)</source>
        <translation>平差后 (mm)</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>算法</translation>
    </message>
    <message>
        <source>All combinations</source>
        <translation>所有组合</translation>
    </message>
    <message>
        <source>Along the damage (m)</source>
        <translation>沿损坏部分 (m)</translation>
    </message>
    <message>
        <source>Along the section (m)</source>
        <translation>沿断面 (m)</translation>
    </message>
    <message>
        <source>April</source>
        <translation>4 月</translation>
    </message>
    <message>
        <source>August</source>
        <translation>8 月</translation>
    </message>
    <message>
        <source>Before (mm)</source>
        <translation>平差前 (mm)</translation>
    </message>
    <message>
        <source>Below the plane</source>
        <translation>平面之下</translation>
    </message>
    <message>
        <source>By %1, %2 was measured.</source>
        <translation>%1：共测量 %2。</translation>
    </message>
    <message>
        <source>By %1, %2 were measured.</source>
        <translation>%1：共测量 %2。</translation>
    </message>
    <message>
        <source>By %1, smaller than three spots of the beam that measured them: %2. Of these the scan shows the beam as much as the object. The RMSE of the others is %3 %.</source>
        <translation>按%1，小于测量光束三个光斑的对象：%2。对这些对象，扫描所反映的光束与对象各半。其余对象的 RMSE 为 %3 %。</translation>
    </message>
    <message>
        <source>Cell (m)</source>
        <translation>单元 (m)</translation>
    </message>
    <message>
        <source>Changed since it became part of the case: %1. See “Evidence used”.</source>
        <translation>成为案件的一部分之后发生改变：%1。见“所用证据”。</translation>
    </message>
    <message>
        <source>Check against known distances</source>
        <translation>用已知距离核验</translation>
    </message>
    <message>
        <source>Cleaning and parts of the scene</source>
        <translation>清理与现场物体</translation>
    </message>
    <message>
        <source>Cleaning and thinning</source>
        <translation>清理与稀释</translation>
    </message>
    <message>
        <source>Closure (mm)</source>
        <translation>闭合差 (mm)</translation>
    </message>
    <message>
        <source>Closure (°)</source>
        <translation>闭合差 (°)</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>点云数</translation>
    </message>
    <message>
        <source>Comparison of registration methods</source>
        <translation>配准方法的比较</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>组件</translation>
    </message>
    <message>
        <source>Corrected (mm)</source>
        <translation>改正量 (mm)</translation>
    </message>
    <message>
        <source>Corrected (°)</source>
        <translation>改正量 (°)</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>是否计入</translation>
    </message>
    <message>
        <source>Damaged, and read only in part: %1. See “Evidence used”.</source>
        <translation>已损坏，只读取了一部分：%1。见“所用证据”。</translation>
    </message>
    <message>
        <source>December</source>
        <translation>12 月</translation>
    </message>
    <message>
        <source>Depth (m)</source>
        <translation>深度 (m)</translation>
    </message>
    <message>
        <source>Difference (mm)</source>
        <translation>差值 (mm)</translation>
    </message>
    <message>
        <source>Digital reconstruction of a road-accident scene from laser scans</source>
        <translation>根据激光扫描对道路交通事故现场进行的数字化重建</translation>
    </message>
    <message>
        <source>Distance (mm)</source>
        <translation>距离 (mm)</translation>
    </message>
    <message>
        <source>Distance to local planes</source>
        <translation>到局部平面的距离</translation>
    </message>
    <message>
        <source>Distance to the global cloud</source>
        <translation>到全局点云的距离</translation>
    </message>
    <message>
        <source>Distances of the scan's points to the local planes of the global cloud</source>
        <translation>扫描各点到全局点云局部平面的距离</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Each cloud is registered to the one before it, starting from no motion at all. With estimates P and known poses Q, E = (Q(i)⁻¹ Q(i+D))⁻¹ (P(i)⁻¹ P(i+D)) is the error of a relative pose, D = %1; the relative pose error (RPE) is the root mean square of the lengths of its translations, and its rotation part that of its angles. A pose counts whatever the registration says of it; where it gives none, the scanner counts as not moved.</source>
        <translation>每个点云都配准到前一个点云，从完全没有运动开始。设估计位姿为 P，已知位姿为 Q，则 E = (Q(i)⁻¹ Q(i+D))⁻¹ (P(i)⁻¹ P(i+D)) 是相对位姿的误差，D = %1；相对位姿误差 (RPE) 是其平移长度的均方根，其旋转部分是其转角的均方根。不论配准对自身作何评价，位姿都计入；没有给出位姿时，视为扫描仪未移动。</translation>
    </message>
    <message>
        <source>Ended because</source>
        <translation>结束原因</translation>
    </message>
    <message>
        <source>Every combination that was run</source>
        <translation>所运行的全部组合</translation>
    </message>
    <message>
        <source>Evidence used</source>
        <translation>所用证据</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>Extent (m)</source>
        <translation>范围 (m)</translation>
    </message>
    <message>
        <source>Failed of pairs</source>
        <translation>失败对数</translation>
    </message>
    <message>
        <source>February</source>
        <translation>2 月</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>File %1</source>
        <translation>文件 %1</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Filtering (s)</source>
        <translation>滤波 (s)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Found with</source>
        <translation>计算所用参数</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>查找方式：%1。</translation>
    </message>
    <message>
        <source>From %1, %2 was measured.</source>
        <translation>由 %1测得 %2。</translation>
    </message>
    <message>
        <source>From %1, %2 were measured.</source>
        <translation>由 %1测得 %2。</translation>
    </message>
    <message>
        <source>Global cloud</source>
        <translation>全局点云</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>高度 (m)</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>约束情况</translation>
    </message>
    <message>
        <source>Hollow bars are excluded objects; n/m: not measurable by that method.</source>
        <translation>空心柱为已剔除的对象；“未测”表示该方法无法测量。</translation>
    </message>
    <message>
        <source>Improved NDT has the lower relative pose error at %1 of %2; the mean over them is %3 mm, that of classic NDT %4 mm.</source>
        <translation>改进 NDT 在 %2中的 %1 级上相对位姿误差较低；各级平均为 %3 mm，经典 NDT 为 %4 mm。</translation>
    </message>
    <message>
        <source>Improved NDT, preset</source>
        <translation>改进 NDT 的预设</translation>
    </message>
    <message>
        <source>January</source>
        <translation>1 月</translation>
    </message>
    <message>
        <source>July</source>
        <translation>7 月</translation>
    </message>
    <message>
        <source>June</source>
        <translation>6 月</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Known (m)</source>
        <translation>已知值 (m)</translation>
    </message>
    <message>
        <source>Known distances at the scene</source>
        <translation>现场的已知距离</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Layers that overlap were registered pair by pair, and all their poses were then adjusted together by least squares, each pair with its own covariance; the global cloud is held. Before the adjustment a closed way through the pairs fails to end where it began: that is the loop's closure.</source>
        <translation>相互重叠的图层先逐对配准，然后按最小二乘法对其全部位姿一并平差，每对采用其自身的协方差；全局点云保持不动。平差之前，沿各对走一圈并不能回到起点：这就是闭合环的闭合差。</translation>
    </message>
    <message>
        <source>Length (m)</source>
        <translation>长度 (m)</translation>
    </message>
    <message>
        <source>Lengths by object and method</source>
        <translation>各对象、各方法的长度</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>闭合环</translation>
    </message>
    <message>
        <source>Loops, and by how much they failed to close before the adjustment</source>
        <translation>闭合环及其平差前的闭合差</translation>
    </message>
    <message>
        <source>March</source>
        <translation>3 月</translation>
    </message>
    <message>
        <source>May</source>
        <translation>5 月</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Mean (m)</source>
        <translation>平均值 (m)</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>Measured (m)</source>
        <translation>测得 (m)</translation>
    </message>
    <message>
        <source>Measured by %1, %2 with a tape value show a root mean square relative error of %3</source>
        <translation>%1：有卷尺值的 %2的均方根相对误差为 %3</translation>
    </message>
    <message>
        <source>Measured lengths</source>
        <translation>测量的长度</translation>
    </message>
    <message>
        <source>Measured lengths against the tape: %1</source>
        <translation>测量长度与卷尺值的比较：%1</translation>
    </message>
    <message>
        <source>Method %1</source>
        <translation>方法 %1</translation>
    </message>
    <message>
        <source>Method and parameters</source>
        <translation>方法与参数</translation>
    </message>
    <message>
        <source>Metres per unit of the file</source>
        <translation>文件的每单位米数</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>Moved (mm)</source>
        <translation>移动 (mm)</translation>
    </message>
    <message>
        <source>Moved by the fit</source>
        <translation>拟合的移动量</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>No loop closes here, so nothing controls the pairs.</source>
        <translation>此处没有闭合环，因此各对没有检核。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Not measurable: %1.</source>
        <translation>无法测量：%1。</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>注：%1。</translation>
    </message>
    <message>
        <source>Notes and warnings</source>
        <translation>说明与警告</translation>
    </message>
    <message>
        <source>November</source>
        <translation>11 月</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象数</translation>
    </message>
    <message>
        <source>Objects measured by %1</source>
        <translation>%1所测的对象</translation>
    </message>
    <message>
        <source>October</source>
        <translation>10 月</translation>
    </message>
    <message>
        <source>Of a fitted end the uncertainty is that of the fit, from the scatter of its points about the feature and their number. Repeats are fitted to the same points, so this part does not shrink with their number. A surface that faces along the length is seen from its own side of the site alone, at another time than the one at the other end: 10 mm (one standard deviation) are added for the drift of the aircraft’s navigation.</source>
        <translation>拟合端点的不确定度取自拟合本身，由各点相对特征的离散程度及点数得出。各次重复所拟合的是相同的点，因此这一部分不随重复次数减小。朝向长度方向的表面只能从其所在一侧看到，与另一端的表面在不同时刻测得：为飞行器导航漂移另计 10 mm（一倍标准差）。</translation>
    </message>
    <message>
        <source>Of an object that is no straight distance the row gives the main figure of its kind, such as the length along a mark or a radius; all its figures stand under “Other figures”.</source>
        <translation>不是直线距离的对象，该行给出其类型的主要数值，例如沿痕迹的长度或半径；其全部数值见“其他数值”一节。</translation>
    </message>
    <message>
        <source>Of some files only a part was loaded: %1.</source>
        <translation>有些文件只载入了一部分：%1。</translation>
    </message>
    <message>
        <source>Only part of %1 could be read: %2</source>
        <translation>%1 只有一部分能够读取：%2</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作人员</translation>
    </message>
    <message>
        <source>Other figures</source>
        <translation>其他数值</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠度</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>配准对</translation>
    </message>
    <message>
        <source>Pairs, and by how much the adjustment corrected them</source>
        <translation>各配准对及平差对其的改正</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Parts of the scene</source>
        <translation>现场物体</translation>
    </message>
    <message>
        <source>Parts were separated in the clouds by what hangs together, or by hand. Their sizes are those of the upright box round all of their points, noise included: they help to tell the parts apart and are no measurements.</source>
        <translation>点云中的物体是按点是否相连或由人工分离的。其尺寸是包围其全部点（包括噪声）的直立长方体的尺寸：仅有助于区分各物体，不是测量结果。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Points that do not belong to the scene were taken out of it before anything was fitted or measured. The files are unchanged; the fused cloud holds these points, too, with the flag “withheld”, so that anyone can put them back and see what was taken.</source>
        <translation>不属于现场的点在拟合和测量之前已从现场中移除。文件未作改动；融合点云也包含这些点，并带有“保留点”(withheld) 标志，因此任何人都可以将其放回，并查看移除了什么。</translation>
    </message>
    <message>
        <source>Points with a counterpart</source>
        <translation>有对应点的点</translation>
    </message>
    <message>
        <source>Pose (rotation | translation in m)</source>
        <translation>位姿（旋转 | 平移，m）</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>处理器</translation>
    </message>
    <message>
        <source>Published: Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171, table %1 (CC BY 4.0), measured on a pavilion sequence of the ETH ASL data sets on an i7-12900K. The figures beside them were measured here, on the sequence above and on this machine: the columns can be compared in their course, not in their size.</source>
        <translation>已发表：Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171，表 %1 (CC BY 4.0)，在 i7-12900K 上对 ETH ASL 数据集的亭子序列测得。旁边的数字是在此处对上述序列、在本机上测得的：各列可比较变化趋势，不可比较大小。</translation>
    </message>
    <message>
        <source>RE (%)</source>
        <translation>RE (%)</translation>
    </message>
    <message>
        <source>RMS (mm)</source>
        <translation>RMS (mm)</translation>
    </message>
    <message>
        <source>RMSE (%)</source>
        <translation>RMSE (%)</translation>
    </message>
    <message>
        <source>RMSE, all (mm)</source>
        <translation>RMSE，全部 (mm)</translation>
    </message>
    <message>
        <source>RMSE, all objects (%)</source>
        <translation>RMSE，全部对象 (%)</translation>
    </message>
    <message>
        <source>RPE (m)</source>
        <translation>RPE (m)</translation>
    </message>
    <message>
        <source>RPE (°)</source>
        <translation>RPE (°)</translation>
    </message>
    <message>
        <source>Radius of the filters</source>
        <translation>滤波半径</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Registration is the fitting of a scan into the frame of the global cloud. A pose maps a point x of the file to R (s x) + t, with the rotation R, the metres per unit s and the translation t; R and t are rigid and change no length. Exact values are in registration.json.</source>
        <translation>配准是把扫描拟合到全局点云的坐标系中。位姿把文件中的点 x 变换为 R (s x) + t，其中 R 为旋转，s 为每单位米数，t 为平移；R 和 t 是刚性的，不改变任何长度。精确数值见 registration.json。</translation>
    </message>
    <message>
        <source>Relative error of each object by method, in percent of its tape value</source>
        <translation>各对象按方法的相对误差，以卷尺值的百分数表示</translation>
    </message>
    <message>
        <source>Relative pose error (RMS) by voxel</source>
        <translation>各体素尺寸的相对位姿误差 (RMS)</translation>
    </message>
    <message>
        <source>Relative pose error, rotation (°); not published</source>
        <translation>相对位姿误差，旋转 (°)；未发表</translation>
    </message>
    <message>
        <source>Relative pose error, translation (m)</source>
        <translation>相对位姿误差，平移 (m)</translation>
    </message>
    <message>
        <source>Repeat SD (m)</source>
        <translation>重复标准差 (m)</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Rotation part of the relative pose error (RMS) by voxel</source>
        <translation>各体素尺寸的相对位姿误差 (RMS) 的旋转部分</translation>
    </message>
    <message>
        <source>Rows of a method named “fitted” take the same picks, but not the single points that were hit: round each pick a plane, an edge or another feature was fitted to all points, strays given no weight, and the length runs between the features. What is known of the scanner is used: its noise lies along the beam, and an edge is read from the beams that pass along it. A pick round which nothing was fitted counts as the point it is; the notes name these. Both ways are given, so that either can be checked against the other.</source>
        <translation>方法名带“fitted”的各行采用相同的点选，但不用击中的单个点：在每个点选周围，对所有点拟合平面、棱边或其他特征，离群点不计权，长度在特征之间量取。其中利用了对扫描仪的了解：其噪声沿光束方向，棱边由沿其掠过的光束读出。周围未能拟合出特征的点选按其点本身计；备注中列出这些点选。两种方式均予给出，以便相互核对。</translation>
    </message>
    <message>
        <source>SD of RE (%)</source>
        <translation>RE 的标准差 (%)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Scans fitted to it</source>
        <translation>配准到它的扫描</translation>
    </message>
    <message>
        <source>Scene measurement report</source>
        <translation>现场测量报告</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>Sensor noise assumed for each scan</source>
        <translation>各扫描采用的传感器噪声</translation>
    </message>
    <message>
        <source>September</source>
        <translation>9 月</translation>
    </message>
    <message>
        <source>Sequence %1</source>
        <translation>序列 %1</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>是否稳定</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Share (%)</source>
        <translation>比例 (%)</translation>
    </message>
    <message>
        <source>Site (WGS 84)</source>
        <translation>地点 (WGS 84)</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Software and times</source>
        <translation>软件与用时</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Standard deviation (mm)</source>
        <translation>标准差 (mm)</translation>
    </message>
    <message>
        <source>Standard deviation of a layer's place (at its middle) before and after the adjustment</source>
        <translation>平差前后图层位置（在其中心处）的标准差</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步数</translation>
    </message>
    <message>
        <source>Steps between clouds</source>
        <translation>点云之间的步距</translation>
    </message>
    <message>
        <source>Steps of the fit, from coarse to fine cells</source>
        <translation>拟合的各级，从粗单元到细单元</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>摘要</translation>
    </message>
    <message>
        <source>Table 2: classic and improved NDT</source>
        <translation>表 2：经典 NDT 与改进 NDT</translation>
    </message>
    <message>
        <source>Table 3: filters before improved NDT</source>
        <translation>表 3：改进 NDT 之前的滤波</translation>
    </message>
    <message>
        <source>Tape (m)</source>
        <translation>卷尺 (m)</translation>
    </message>
    <message>
        <source>The SHA-256 value of a file is a fingerprint of its content: a file with the same value is the same file, byte by byte. Whoever holds the files can recompute it with any tool.</source>
        <translation>文件的 SHA-256 值是其内容的指纹：具有相同值的文件逐字节相同。持有文件的任何人都可以用任何工具重新计算。</translation>
    </message>
    <message>
        <source>The budgets below list what the uncertainty of each object’s main figure is made of. The sensitivity says by how much the figure changes when the input does; the share is that of the combined variance u². Those of all figures are in the file uncertainty.csv.</source>
        <translation>以下各不确定度分量表列出每个对象主要数值的不确定度由哪些分量构成。灵敏度表示输入变化时该数值变化多少；比例是在合成方差 u² 中所占的比例。全部数值的分量表见文件 uncertainty.csv。</translation>
    </message>
    <message>
        <source>The case</source>
        <translation>案件</translation>
    </message>
    <message>
        <source>The filter with the lowest relative pose error is %1. Published: gaussian at every size.</source>
        <translation>相对位姿误差最低的滤波为%1。已发表：各级均为高斯滤波。</translation>
    </message>
    <message>
        <source>The number of a file is the number that its points carry in the fused cloud (“point source ID”). The files were only read; measuring is done on their original points, never on thinned or smoothed ones.</source>
        <translation>文件的编号即其点在融合点云中所带的编号（“点源 ID”）。文件只被读取；测量在其原始点上进行，从不在稀释或平滑后的点上进行。</translation>
    </message>
    <message>
        <source>The same files and parameters give the same results, bit for bit, on every run and for any number of processor cores; times and dates alone differ. manifest.json lists the SHA-256 values of all inputs and results.</source>
        <translation>相同的文件和参数在每次运行、任意处理器核数下都得到逐位相同的结果；只有用时和日期不同。manifest.json 列出所有输入和结果的 SHA-256 值。</translation>
    </message>
    <message>
        <source>The scale of what %1 measured is verified: it agrees with the known distance at the scene within the tolerance set for it.</source>
        <translation>由%1测得的结果，其比例已校核：与现场的已知距离相符，差值在为其设定的允差之内。</translation>
    </message>
    <message>
        <source>The scan “%1” was fitted to the global cloud; %2 of its points found a counterpart, at a root mean square distance of %3 mm.</source>
        <translation>扫描“%1”已拟合到全局点云；其点的 %2 找到了对应点，均方根距离为 %3 mm。</translation>
    </message>
    <message>
        <source>The scan “%1” was fitted to the global cloud; %2 of its points found a counterpart, at a root mean square distance of %3 mm. The computation reached its limit of steps before it settled: see the section on registration.</source>
        <translation>扫描“%1”已拟合到全局点云；其点的 %2 找到了对应点，均方根距离为 %3 mm。计算在稳定之前达到了步数上限：见“配准”一节。</translation>
    </message>
    <message>
        <source>The scene is reconstructed in these steps. The global cloud is cleaned and thinned to evenly spread points, which are used for fitting only. Each handheld scan is brought to a first position by picked pairs of points or by a given pose, and then fitted to the global cloud by the normal distributions transform (NDT): the space of the global cloud is divided into cells, the points of each cell are described by their mean and spread, and the scan is moved, without bending or scaling, to where its points are most probable; the cells become smaller step by step. Lengths are then measured between points picked in the original clouds. After Zhang, Guan, Liu and Zhang, World Electric Vehicle Journal 2025, 16(3), 171.</source>
        <translation>现场按以下步骤重建。全局点云经过清理并稀释为均匀分布的点，这些点只用于拟合。每个手持扫描先由点对或给定的位姿置于初始位置，然后用正态分布变换 (NDT) 拟合到全局点云：把全局点云的空间划分为单元，用均值和离散程度描述每个单元中的点，在不弯曲、不缩放的情况下移动扫描，直到其点的概率最大；单元逐级变小。然后在原始点云中选取的点之间测量长度。依据 Zhang, Guan, Liu, Zhang, World Electric Vehicle Journal 2025, 16(3), 171。</translation>
    </message>
    <message>
        <source>The sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>The sum of squares is %1 with %2 degrees of freedom (variance factor %3): the pairs agree within their covariances.</source>
        <translation>平方和为 %1，自由度为 %2（方差因子 %3）：各配准对在其协方差范围内一致。</translation>
    </message>
    <message>
        <source>The sum of squares is %1 with %2 degrees of freedom (variance factor %3): the pairs disagree by more than their covariances allow, which were made larger by that factor.</source>
        <translation>平方和为 %1，自由度为 %2（方差因子 %3）：各配准对的不一致超出其协方差所允许的范围，协方差已按该因子放大。</translation>
    </message>
    <message>
        <source>The survey was not verified: no known distance at the scene was measured with it.</source>
        <translation>本次勘测未经核验：没有测量过现场的已知距离。</translation>
    </message>
    <message>
        <source>The tape itself is read to its last digit only, which gives it a standard uncertainty of that digit divided by the square root of 12. This limits what a relative error can show, most for short objects: here %1 for %2.</source>
        <translation>卷尺本身只读到最后一位，由此带来的标准不确定度为该位单位除以 12 的平方根。这限制了相对误差所能说明的程度，对短小对象尤甚：此处%2为 %1。</translation>
    </message>
    <message>
        <source>The tape measure is the baseline. The relative error (RE) of an object is its measured length minus its tape length, divided by the tape length: +2 % means measured 2 % too long. SD is the standard deviation of these relative errors. An object whose RE is larger than twice the SD, either way, is excluded once; the root mean square error (RMSE) is the square root of the mean of the squared RE of the others. RE, SD and RMSE are proportions, not lengths; the RMSE of the differences in millimetres is given beside them.</source>
        <translation>以卷尺为基准。对象的相对误差 (RE) 为其测量长度减去卷尺长度再除以卷尺长度：+2 % 表示测得偏长 2 %。SD 为这些相对误差的标准差。RE 的绝对值大于 2 倍 SD 的对象剔除一次；均方根误差 (RMSE) 为其余对象 RE 平方的平均值的平方根。RE、SD 和 RMSE 是比例而不是长度；以毫米表示的差值的 RMSE 一并给出。</translation>
    </message>
    <message>
        <source>The uncertainty of a length is found after the “Guide to the expression of uncertainty in measurement” (GUM). Its standard uncertainty u has four parts, added as squares: the scatter of the repeats (their standard deviation divided by the square root of their number), the standard uncertainty of each of the two ends, and, where the ends lie on different scans, the registration's share along the length. The uncertainty of an end joins the noise of the sensor with the spacing d of the points around it, which counts d divided by the square root of 12. The expanded uncertainty is U = k u, where k is taken from Student's t distribution so that the interval holds the true value with a probability of 95 % although only few repeats were made. With one repeat the scatter is unknown and U is not given.</source>
        <translation>长度的不确定度按《测量不确定度表示指南》(GUM) 求得。其标准不确定度 u 由四部分按平方和合成：各次测量的离散（其标准差除以次数的平方根）、两个端点各自的标准不确定度，以及当两端位于不同扫描上时配准沿长度方向的分量。端点的不确定度由传感器噪声与其周围点的间距 d 合成，间距按 d 除以 12 的平方根计入。扩展不确定度为 U = k u，其中 k 取自学生 t 分布，使得虽然只作了少数几次测量，该区间仍以 95 % 的概率包含真值。只测量一次时离散未知，不给出 U。</translation>
    </message>
    <message>
        <source>There are %1 on this run; they are listed under “Notes and warnings”.</source>
        <translation>本次运行有 %1；列于“说明与警告”。</translation>
    </message>
    <message>
        <source>There is %1 on this run; they are listed under “Notes and warnings”.</source>
        <translation>本次运行有 %1；列于“说明与警告”。</translation>
    </message>
    <message>
        <source>This run</source>
        <translation>本次运行</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程数</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>用时</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>用时 (s)</translation>
    </message>
    <message>
        <source>Time of registration (s), all pairs</source>
        <translation>配准用时 (s)，全部对</translation>
    </message>
    <message>
        <source>Time of registration, all pairs, by voxel</source>
        <translation>各体素尺寸的配准用时，全部对</translation>
    </message>
    <message>
        <source>Time taken by each stage</source>
        <translation>各阶段用时</translation>
    </message>
    <message>
        <source>Together, until this report</source>
        <translation>合计，至本报告为止</translation>
    </message>
    <message>
        <source>Tolerance (mm)</source>
        <translation>允差 (mm)</translation>
    </message>
    <message>
        <source>Turned (°)</source>
        <translation>转动 (°)</translation>
    </message>
    <message>
        <source>Uncertainty of the figures</source>
        <translation>各数值的不确定度</translation>
    </message>
    <message>
        <source>Uncertainty of the place (95 %)</source>
        <translation>位置不确定度 (95 %)</translation>
    </message>
    <message>
        <source>Uncertainty of the turn (95 %)</source>
        <translation>转角不确定度 (95 %)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>是否采用</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>取值</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Voxel (m)</source>
        <translation>体素 (m)</translation>
    </message>
    <message>
        <source>WARNING: the check against a known distance FAILED for %1. Figures of this report by these methods must not be relied on until the cause is found.</source>
        <translation>警告：%1未通过已知距离核验！在查明原因之前，不得采信本报告中由这些方法得出的数值。</translation>
    </message>
    <message>
        <source>WARNING: the check against a known distance FAILED for %1. Figures of this report by this method must not be relied on until the cause is found.</source>
        <translation>警告：%1未通过已知距离核验！在查明原因之前，不得采信本报告中由此方法得出的数值。</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>路程</translation>
    </message>
    <message>
        <source>What %1 measured was not verified: no known distance at the scene was measured with it.</source>
        <translation>由%1测得的结果未经核验：没有用它测量过现场的已知距离。</translation>
    </message>
    <message>
        <source>What was taken out of the clouds</source>
        <translation>从点云中移除的内容</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Width (m)</source>
        <translation>宽度 (m)</translation>
    </message>
    <message>
        <source>and</source>
        <translation>和</translation>
    </message>
    <message>
        <source>at %1 m %2</source>
        <translation>%1 m 时%2</translation>
    </message>
    <message>
        <source>below 0.001</source>
        <translation>低于 0.001</translation>
    </message>
    <message>
        <source>classic NDT</source>
        <translation>经典 NDT</translation>
    </message>
    <message>
        <source>held in every direction</source>
        <translation>各个方向均受约束</translation>
    </message>
    <message>
        <source>improved NDT</source>
        <translation>改进 NDT</translation>
    </message>
    <message>
        <source>in all</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>it %1</source>
        <translation>它%1</translation>
    </message>
    <message>
        <source>known distance failed: %1 by %2 is %3 m and was measured as %4 m, %5 mm off where %6 mm are allowed</source>
        <translation>已知距离核验未通过：%1（%2）为 %3 m，测得 %4 m，相差 %5 mm，允许 %6 mm</translation>
    </message>
    <message>
        <source>largest (m)</source>
        <translation>最大 (m)</translation>
    </message>
    <message>
        <source>median (m)</source>
        <translation>中位数 (m)</translation>
    </message>
    <message>
        <source>no: %1</source>
        <translation>否：%1</translation>
    </message>
    <message>
        <source>no: the limit of steps was reached</source>
        <translation>否：达到步数上限</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>not held: %1</source>
        <translation>未受约束：%1</translation>
    </message>
    <message>
        <source>not measurable</source>
        <translation>无法测量</translation>
    </message>
    <message>
        <source>of</source>
        <translation>，共</translation>
    </message>
    <message>
        <source>of %1 points, %2</source>
        <translation>共 %1 个点，占 %2</translation>
    </message>
    <message>
        <source>one of every %1 points</source>
        <translation>每 %1 个点取一个</translation>
    </message>
    <message>
        <source>the points from %1 to %2 in the file's own frame and unit</source>
        <translation>在文件自身的坐标系和单位中从 %1 到 %2 的点</translation>
    </message>
    <message>
        <source>the relative errors are systematic (mean %1 %): a common cause, such as a wrong scale, is likelier than chance</source>
        <translation>相对误差是系统性的（平均 %1 %）：共同的原因（例如比例有误）比偶然更有可能</translation>
    </message>
    <message>
        <source>u of the figure</source>
        <translation>数值的 u</translation>
    </message>
    <message>
        <source>u of the input</source>
        <translation>输入的 u</translation>
    </message>
    <message>
        <source>up to %1 m and %2°</source>
        <translation>不超过 %1 m 和 %2°</translation>
    </message>
    <message>
        <source>yes, after %1</source>
        <translation>是，经过 %1</translation>
    </message>
</context>
<context>
    <name>core/scene</name>
    <message>
        <source>%1 changes were not saved (the last: %2, %3)</source>
        <translation>有 %1 项更改未保存（最后一项：%2，%3）</translation>
    </message>
    <message>
        <source>%1 fitted</source>
        <translation>%1（拟合）</translation>
    </message>
    <message>
        <source>%1 is no length: '%2'</source>
        <translation>%1不是长度：“%2”</translation>
    </message>
    <message>
        <source>%1 repeat left out: %2</source>
        <translation>有 %1 次测量略去：%2</translation>
    </message>
    <message>
        <source>%1 repeats by the points themselves: no feature was fitted at either end</source>
        <translation>%1 次重复按点本身计：两端均未拟合出特征</translation>
    </message>
    <message>
        <source>%1 repeats left out: %2</source>
        <translation>有 %1 次测量略去：%2</translation>
    </message>
    <message>
        <source>%1 repeats left out: their ends lie on layers that are not registered to each other</source>
        <translation>有 %1 次测量略去：其端点所在的图层未相互配准</translation>
    </message>
    <message>
        <source>%1' is no frame</source>
        <translation>%1”不是坐标系</translation>
    </message>
    <message>
        <source>%1' is no kind of measurement</source>
        <translation>%1”不是测量种类</translation>
    </message>
    <message>
        <source>%1: this copy was changed by another program and is not read; the case is what case.db holds</source>
        <translation>%1：此副本被另一程序更改，不予读取；案件以 case.db 的内容为准</translation>
    </message>
    <message>
        <source>%1; the case as it was saved is used</source>
        <translation>%1；采用已保存的案件</translation>
    </message>
    <message>
        <source>%1belong to another file than %2, expected SHA-256 %3, found %4</source>
        <translation>%1属于 %2 以外的另一个文件，应为 SHA-256 %3，实为 %4</translation>
    </message>
    <message>
        <source>%1belong to another part of %2, expected %3 points, found %4</source>
        <translation>%1属于 %2 的另一部分，应为 %3 个点，实为 %4</translation>
    </message>
    <message>
        <source>'%1' has a decimal comma</source>
        <translation>“%1”使用了逗号小数点</translation>
    </message>
    <message>
        <source>'%1' has another tape value here</source>
        <translation>“%1”在此处有另一个卷尺值</translation>
    </message>
    <message>
        <source>'%1' is no feature that is fitted</source>
        <translation>“%1”不是可拟合的特征</translation>
    </message>
    <message>
        <source>'%1' is no first pose</source>
        <translation>“%1”不是初始位姿</translation>
    </message>
    <message>
        <source>'%1' is no kind of measurement</source>
        <translation>“%1”不是测量种类</translation>
    </message>
    <message>
        <source>'%1' is no kind of object</source>
        <translation>“%1”不是物体种类</translation>
    </message>
    <message>
        <source>'%1' is no role</source>
        <translation>“%1”不是图层类型</translation>
    </message>
    <message>
        <source>'%1' is no unit of length</source>
        <translation>“%1”不是长度单位</translation>
    </message>
    <message>
        <source>'%1' is no verdict</source>
        <translation>“%1”不是评定</translation>
    </message>
    <message>
        <source>'%1' is not a reason to stop</source>
        <translation>“%1”不是停止原因</translation>
    </message>
    <message>
        <source>'%1' stands twice</source>
        <translation>“%1”出现了两次</translation>
    </message>
    <message>
        <source>1 change was not saved (the last: %1, %2)</source>
        <translation>有 1 项更改未保存（最后一项：%1，%2）</translation>
    </message>
    <message>
        <source>16 numbers, the 4x4 matrix row by row</source>
        <translation>16 个数，逐行排列的 4x4 矩阵</translation>
    </message>
    <message>
        <source>36 numbers, the 6x6 matrix row by row</source>
        <translation>36 个数，逐行排列的 6x6 矩阵</translation>
    </message>
    <message>
        <source>SHA-256 %1, %2 bytes</source>
        <translation>SHA-256 %1，%2 字节</translation>
    </message>
    <message>
        <source>SHA-256 %1, %2 bytes, of %3</source>
        <translation>SHA-256 %1，%2 字节，%3</translation>
    </message>
    <message>
        <source>Vestige does not know this key and leaves it out</source>
        <translation>Vestige 不认识此键，予以忽略</translation>
    </message>
    <message>
        <source>Vestige does not know this parameter and leaves it out</source>
        <translation>Vestige 不认识此参数，予以忽略</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>a box [xmin, ymin, zmin, xmax, ymax, zmax]</source>
        <translation>范围框 [xmin, ymin, zmin, xmax, ymax, zmax]</translation>
    </message>
    <message>
        <source>a case's database is expected here, as a file</source>
        <translation>此处应为案件数据库文件</translation>
    </message>
    <message>
        <source>a colour [red, green, blue]</source>
        <translation>颜色 [红, 绿, 蓝]</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限数</translation>
    </message>
    <message>
        <source>a least coordinate of the box exceeds its greatest</source>
        <translation>范围框的某个最小坐标大于其最大坐标</translation>
    </message>
    <message>
        <source>a length is not below 0</source>
        <translation>长度不得小于 0</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>大于 0 的数</translation>
    </message>
    <message>
        <source>a section box has no such sides</source>
        <translation>剖切框不能有这样的边长</translation>
    </message>
    <message>
        <source>a spacing is not below 0</source>
        <translation>间距不得小于 0</translation>
    </message>
    <message>
        <source>a variance is not below 0</source>
        <translation>方差不得小于 0</translation>
    </message>
    <message>
        <source>a view in perspective has no scale</source>
        <translation>透视视图没有比例尺</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 到 %2 的整数</translation>
    </message>
    <message>
        <source>add layer %1</source>
        <translation>添加图层 %1</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>数组</translation>
    </message>
    <message>
        <source>an axis is a unit vector</source>
        <translation>轴应为单位向量</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>another program is writing to the case</source>
        <translation>另一程序正在写入本案件</translation>
    </message>
    <message>
        <source>another window has this case open</source>
        <translation>另一窗口已打开本案件</translation>
    </message>
    <message>
        <source>being computed from the cloud</source>
        <translation>正在由点云计算</translation>
    </message>
    <message>
        <source>call %1 %2</source>
        <translation>将 %1 的种类设为%2</translation>
    </message>
    <message>
        <source>case.json beside it is the readable copy of the last saved case</source>
        <translation>旁边的 case.json 是最近保存的案件的可读副本</translation>
    </message>
    <message>
        <source>change the case's details</source>
        <translation>更改案件信息</translation>
    </message>
    <message>
        <source>change the view '%1'</source>
        <translation>更改视图“%1”</translation>
    </message>
    <message>
        <source>check the survey by %1</source>
        <translation>用 %1 核验勘测</translation>
    </message>
    <message>
        <source>clean the layer anew, or take &quot;cleaning&quot; out of the case</source>
        <translation>请重新清理该图层，或从案件中去掉 &quot;cleaning&quot;</translation>
    </message>
    <message>
        <source>edits that were made before are offered when the program starts</source>
        <translation>此前所作的编辑在程序启动时提供恢复</translation>
    </message>
    <message>
        <source>expected &quot; at its end</source>
        <translation>末尾应有 &quot;</translation>
    </message>
    <message>
        <source>expected &quot;gap length gap length ...&quot;, whole numbers with one space between</source>
        <translation>应为 &quot;间隔 长度 间隔 长度 ...&quot;，均为整数，以一个空格分隔</translation>
    </message>
    <message>
        <source>expected %1 or auto</source>
        <translation>应为 %1 或 auto</translation>
    </message>
    <message>
        <source>expected 64 hexadecimal digits</source>
        <translation>应为 64 位十六进制数字</translation>
    </message>
    <message>
        <source>expected 64 lower-case hexadecimal digits</source>
        <translation>应为 64 位小写十六进制数字</translation>
    </message>
    <message>
        <source>expected OBJECT | LAYER | REPEAT | a or b, as in the lines above</source>
        <translation>应为 OBJECT | LAYER | REPEAT | a 或 b，与上面各行相同</translation>
    </message>
    <message>
        <source>expected [[x,y,z],[x,y,z]] or {&quot;a&quot;: [layer, [x,y,z]], &quot;b&quot;: [layer, [x,y,z]]}</source>
        <translation>应为 [[x,y,z],[x,y,z]] 或 {&quot;a&quot;: [layer, [x,y,z]], &quot;b&quot;: [layer, [x,y,z]]}</translation>
    </message>
    <message>
        <source>expected a and b of each pair, p1 to the last of each path</source>
        <translation>应为每对的 a 和 b，每条路径的 p1 至最后一点</translation>
    </message>
    <message>
        <source>expected a decimal number with '.'</source>
        <translation>应为以“.”为小数点的数字</translation>
    </message>
    <message>
        <source>expected a direction to look in</source>
        <translation>应为观察方向</translation>
    </message>
    <message>
        <source>expected a parallel camera, or no scale</source>
        <translation>应为平行投影相机，或不给比例尺</translation>
    </message>
    <message>
        <source>expected accepted, doubtful, failed or ambiguous</source>
        <translation>应为 accepted、doubtful、failed 或 ambiguous</translation>
    </message>
    <message>
        <source>expected aerial, handheld or photogrammetry</source>
        <translation>应为 aerial、handheld 或 photogrammetry</translation>
    </message>
    <message>
        <source>expected an object with &quot;vestige&quot;: 1</source>
        <translation>应为含 &quot;vestige&quot;: 1 的对象</translation>
    </message>
    <message>
        <source>expected an odd number of them</source>
        <translation>应为奇数个</translation>
    </message>
    <message>
        <source>expected another layer</source>
        <translation>应为另一图层</translation>
    </message>
    <message>
        <source>expected degrees from -180 to 180</source>
        <translation>应为 -180 到 180 度</translation>
    </message>
    <message>
        <source>expected degrees from -90 to 90</source>
        <translation>应为 -90 到 90 度</translation>
    </message>
    <message>
        <source>expected each end once</source>
        <translation>每个端点应只出现一次</translation>
    </message>
    <message>
        <source>expected each key once</source>
        <translation>每个键应只出现一次</translation>
    </message>
    <message>
        <source>expected fewer points than it has</source>
        <translation>点数应少于其原有点数</translation>
    </message>
    <message>
        <source>expected gradient, step, predicted-decrease, iteration-limit or no-overlap</source>
        <translation>应为 gradient、step、predicted-decrease、iteration-limit 或 no-overlap</translation>
    </message>
    <message>
        <source>expected ids that differ</source>
        <translation>各 id 应不相同</translation>
    </message>
    <message>
        <source>expected layer</source>
        <translation>应为 layer</translation>
    </message>
    <message>
        <source>expected metres above 0 with '.', or nothing</source>
        <translation>应为大于 0 的米数，小数点用“.”，或留空</translation>
    </message>
    <message>
        <source>expected metres above 0, up to 1e7</source>
        <translation>应为大于 0 的米数，不超过 1e7</translation>
    </message>
    <message>
        <source>expected metres of the scene; a list in shifted coordinates needs its shift added first</source>
        <translation>应为场景坐标，单位米；经平移的坐标须先加回平移量</translation>
    </message>
    <message>
        <source>expected names that differ</source>
        <translation>各名称应不相同</translation>
    </message>
    <message>
        <source>expected one of %1</source>
        <translation>应为以下之一：%1</translation>
    </message>
    <message>
        <source>expected point, plane, edge, corner, highest, lowest, circle or centroid</source>
        <translation>应为 point、plane、edge、corner、highest、lowest、circle 或 centroid</translation>
    </message>
    <message>
        <source>expected radians below pi</source>
        <translation>应为小于 π 的弧度</translation>
    </message>
    <message>
        <source>expected that of line %1</source>
        <translation>应为第 %1 行的值</translation>
    </message>
    <message>
        <source>expected the id of a layer</source>
        <translation>应为图层的 id</translation>
    </message>
    <message>
        <source>expected two points for each repeat, one after the other</source>
        <translation>每次测量应为两个点，依次排列</translation>
    </message>
    <message>
        <source>expected up to 1e10</source>
        <translation>应不超过 1e10</translation>
    </message>
    <message>
        <source>expected vehicle, debris, vegetation, ground or other</source>
        <translation>应为 vehicle、debris、vegetation、ground 或 other</translation>
    </message>
    <message>
        <source>expected x,y,z or index,x,y,z or label,x,y,z, decimal numbers with '.', parted by comma, semicolon, tab or blanks</source>
        <translation>应为 x,y,z 或 index,x,y,z 或 label,x,y,z，小数点用“.”，以逗号、分号、制表符或空格分隔</translation>
    </message>
    <message>
        <source>expected {&quot;picks&quot;: CSV}, {&quot;pose&quot;: [16], &quot;scale&quot;: 0.001}, &quot;auto&quot; or &quot;identity&quot;</source>
        <translation>应为 {&quot;picks&quot;: CSV}、{&quot;pose&quot;: [16], &quot;scale&quot;: 0.001}、&quot;auto&quot; 或 &quot;identity&quot;</translation>
    </message>
    <message>
        <source>expected: a case of this version or an earlier one</source>
        <translation>应为：本版本或更早版本的案件</translation>
    </message>
    <message>
        <source>forget %1</source>
        <translation>从列表中去掉 %1</translation>
    </message>
    <message>
        <source>forget some of the parts of the scene, or bring points back</source>
        <translation>请从列表中去掉一些现场物体，或恢复一些点</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>hide layer '%1'</source>
        <translation>隐藏图层“%1”</translation>
    </message>
    <message>
        <source>hide the layer, or remove it from the case</source>
        <translation>请隐藏该图层，或将其从案件中移除</translation>
    </message>
    <message>
        <source>index of what is left</source>
        <translation>其余点的索引</translation>
    </message>
    <message>
        <source>inputs are only ever read; expected: another name</source>
        <translation>输入只会被读取；应为：另一个名称</translation>
    </message>
    <message>
        <source>keep the view '%1'</source>
        <translation>保存视图“%1”</translation>
    </message>
    <message>
        <source>layer '%1': %2 is not the file that became part of the case: expected %3; found %4</source>
        <translation>图层“%1”：%2 不是当初成为案件一部分的文件：应为 %3；实为 %4</translation>
    </message>
    <message>
        <source>length, width and height</source>
        <translation>长、宽、高</translation>
    </message>
    <message>
        <source>measuring in the clouds</source>
        <translation>在点云中测量</translation>
    </message>
    <message>
        <source>move pick %1, repeat %2</source>
        <translation>移动点选 %1，第 %2 次</translation>
    </message>
    <message>
        <source>no case of Vestige has it: it was put there to harm; case.json beside it is readable</source>
        <translation>Vestige 的案件中不会有它：它是为造成损害而放置的；旁边的 case.json 可读</translation>
    </message>
    <message>
        <source>no column is called object</source>
        <translation>没有名为 object 的列</translation>
    </message>
    <message>
        <source>no folder can be made for a copy of the case</source>
        <translation>无法为案件副本创建文件夹</translation>
    </message>
    <message>
        <source>no longer check the survey by %1</source>
        <translation>不再用 %1 核验勘测</translation>
    </message>
    <message>
        <source>none of the states that were kept here can be read</source>
        <translation>此处保留的状态均无法读取</translation>
    </message>
    <message>
        <source>not computed; the next change of the case takes it up</source>
        <translation>未计算；案件下次更改时重新计算</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>not measured with this method</source>
        <translation>未用此方法测量</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>未核验</translation>
    </message>
    <message>
        <source>nothing has been saved here yet</source>
        <translation>此处尚未保存任何内容</translation>
    </message>
    <message>
        <source>nothing is left of the layer</source>
        <translation>该图层没有剩余的点</translation>
    </message>
    <message>
        <source>nothing would be left of the layer</source>
        <translation>该图层将没有剩余的点</translation>
    </message>
    <message>
        <source>one repeat only</source>
        <translation>只有一次测量</translation>
    </message>
    <message>
        <source>one repeat only, so no uncertainty</source>
        <translation>只有一次测量，因此没有不确定度</translation>
    </message>
    <message>
        <source>pick %1, repeat %2</source>
        <translation>点选 %1，第 %2 次</translation>
    </message>
    <message>
        <source>picked on %1, which this case does not have</source>
        <translation>在 %1 上点选，而本案件没有该图层</translation>
    </message>
    <message>
        <source>picked on a layer which this case does not have</source>
        <translation>在本案件没有的图层上点选</translation>
    </message>
    <message>
        <source>position and focal point coincide</source>
        <translation>位置与焦点重合</translation>
    </message>
    <message>
        <source>register layer '%1'</source>
        <translation>配准图层“%1”</translation>
    </message>
    <message>
        <source>register to layer '%1'</source>
        <translation>以图层“%1”为配准目标</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>remove layer '%1'</source>
        <translation>移除图层“%1”</translation>
    </message>
    <message>
        <source>remove repeat %1 of %2</source>
        <translation>移除 %2 的第 %1 次测量</translation>
    </message>
    <message>
        <source>remove the view '%1'</source>
        <translation>移除视图“%1”</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>rename %1 to %2</source>
        <translation>将 %1 重命名为 %2</translation>
    </message>
    <message>
        <source>rename the view '%1' to '%2'</source>
        <translation>将视图“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>repeat %1 of '%2' lacks an end</source>
        <translation>“%2”的第 %1 次测量缺少一个端点</translation>
    </message>
    <message>
        <source>run %1 is empty or touches the one before it</source>
        <translation>第 %1 段为空或与前一段相接</translation>
    </message>
    <message>
        <source>save it under another name</source>
        <translation>请以其他名称保存</translation>
    </message>
    <message>
        <source>save the view '%1'</source>
        <translation>保存视图“%1”</translation>
    </message>
    <message>
        <source>set %1 of %2</source>
        <translation>设定 %2 的 %1</translation>
    </message>
    <message>
        <source>set the kind of %1</source>
        <translation>设定 %1 的种类</translation>
    </message>
    <message>
        <source>set the tape of %1</source>
        <translation>设定 %1 的卷尺值</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>show layer '%1'</source>
        <translation>显示图层“%1”</translation>
    </message>
    <message>
        <source>six numbers</source>
        <translation>六个数</translation>
    </message>
    <message>
        <source>take its cleaning back first</source>
        <translation>请先撤回其清理</translation>
    </message>
    <message>
        <source>taking points out</source>
        <translation>正在移除点</translation>
    </message>
    <message>
        <source>the JSON holds more values than any case</source>
        <translation>JSON 中的值多于任何案件</translation>
    </message>
    <message>
        <source>the JSON is nested deeper than any case</source>
        <translation>JSON 的嵌套深于任何案件</translation>
    </message>
    <message>
        <source>the angle of view is too wide</source>
        <translation>视角过大</translation>
    </message>
    <message>
        <source>the case cannot be written here: %1</source>
        <translation>案件无法写入此处：%1</translation>
    </message>
    <message>
        <source>the case cannot be written: it is read-only</source>
        <translation>案件无法写入：它是只读的</translation>
    </message>
    <message>
        <source>the case has no layer '%1'</source>
        <translation>案件没有图层“%1”</translation>
    </message>
    <message>
        <source>the case is of a version that this program does not know</source>
        <translation>案件的版本是本程序不认识的</translation>
    </message>
    <message>
        <source>the case was written by a later version of Vestige</source>
        <translation>案件由更高版本的 Vestige 写成</translation>
    </message>
    <message>
        <source>the case would hold %1 MB, more than the %2 MB that are read again</source>
        <translation>案件将有 %1 MB，超过可重新读取的 %2 MB</translation>
    </message>
    <message>
        <source>the case's database answers: %1</source>
        <translation>案件数据库报告：%1</translation>
    </message>
    <message>
        <source>the case's database cannot be opened%1</source>
        <translation>无法打开案件数据库%1</translation>
    </message>
    <message>
        <source>the case's folder was moved or deleted</source>
        <translation>案件的文件夹已被移动或删除</translation>
    </message>
    <message>
        <source>the covariance xx, xy, xz, yy, yz, zz</source>
        <translation>协方差 xx、xy、xz、yy、yz、zz</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>the disk refused%1</source>
        <translation>磁盘拒绝写入%1</translation>
    </message>
    <message>
        <source>the first pose of '%1' leads to itself</source>
        <translation>“%1”的初始位姿指向自身</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>缺少键“%1”</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; stands twice in one object</source>
        <translation>键“%1”在同一对象中出现了两次</translation>
    </message>
    <message>
        <source>the kind %1 has no setting '%2'</source>
        <translation>种类 %1 没有设置“%2”</translation>
    </message>
    <message>
        <source>the label is '%1'</source>
        <translation>标签为“%1”</translation>
    </message>
    <message>
        <source>the last of %1 points has no partner</source>
        <translation>%1 个点中的最后一个没有配对点</translation>
    </message>
    <message>
        <source>the layer is not loaded yet</source>
        <translation>该图层尚未载入</translation>
    </message>
    <message>
        <source>the lock of this case cannot be had</source>
        <translation>无法取得本案件的锁</translation>
    </message>
    <message>
        <source>the longitude is out of range</source>
        <translation>经度超出范围</translation>
    </message>
    <message>
        <source>the object has no name</source>
        <translation>该对象没有名称</translation>
    </message>
    <message>
        <source>the path has %1 points</source>
        <translation>该路径有 %1 个点</translation>
    </message>
    <message>
        <source>the path holds a zero byte</source>
        <translation>路径中含有零字节</translation>
    </message>
    <message>
        <source>the paths have more than %1 points</source>
        <translation>各路径的点超过 %1 个</translation>
    </message>
    <message>
        <source>the point is farther from 0 than any place on Earth</source>
        <translation>该点到 0 的距离超过地球上任何地点</translation>
    </message>
    <message>
        <source>the point lies far away from everything in layer '%1'</source>
        <translation>该点远离图层“%1”中的一切</translation>
    </message>
    <message>
        <source>the points taken out of layer '%1'</source>
        <translation>从图层“%1”移除的点</translation>
    </message>
    <message>
        <source>the reference is not known four times better than the tolerance</source>
        <translation>参考值的不确定度大于允差的四分之一</translation>
    </message>
    <message>
        <source>the runs end with a space</source>
        <translation>各段以空格结尾</translation>
    </message>
    <message>
        <source>the runs end within a pair</source>
        <translation>各段在一对数的中间结束</translation>
    </message>
    <message>
        <source>the runs reach beyond the layer's %1 points</source>
        <translation>各段超出该图层的 %1 个点</translation>
    </message>
    <message>
        <source>the tape value</source>
        <translation>卷尺值</translation>
    </message>
    <message>
        <source>the tape's resolution</source>
        <translation>卷尺的分辨力</translation>
    </message>
    <message>
        <source>the text is empty</source>
        <translation>文本为空</translation>
    </message>
    <message>
        <source>the uncertainty of the measured length, %1 mm, is larger than the tolerance</source>
        <translation>测量长度的不确定度 %1 mm 大于允差</translation>
    </message>
    <message>
        <source>their points lie on layers that are not registered to each other</source>
        <translation>其各点所在的图层未相互配准</translation>
    </message>
    <message>
        <source>there are %1 bins here</source>
        <translation>此处有 %1 个区间</translation>
    </message>
    <message>
        <source>there are %1 values here</source>
        <translation>此处有 %1 个值</translation>
    </message>
    <message>
        <source>there are both picks and a pose here</source>
        <translation>此处既有点对又有位姿</translation>
    </message>
    <message>
        <source>there are neither picks nor a pose here</source>
        <translation>此处既没有点对也没有位姿</translation>
    </message>
    <message>
        <source>there are no points</source>
        <translation>没有点</translation>
    </message>
    <message>
        <source>there are no points here</source>
        <translation>此处没有点</translation>
    </message>
    <message>
        <source>there are no rows</source>
        <translation>没有行</translation>
    </message>
    <message>
        <source>there are no rows below the header</source>
        <translation>表头以下没有行</translation>
    </message>
    <message>
        <source>there is %1 here</source>
        <translation>此处是%1</translation>
    </message>
    <message>
        <source>there is no number of points at character %1 of the runs</source>
        <translation>各段的第 %1 个字符处没有点数</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>there is one cell</source>
        <translation>只有一个单元格</translation>
    </message>
    <message>
        <source>this case has been open in another window since %1 (%2 on %3, process %4)</source>
        <translation>自 %1 起本案件已在另一窗口中打开（%2，%3，进程 %4）</translation>
    </message>
    <message>
        <source>this database is no case of Vestige</source>
        <translation>此数据库不是 Vestige 的案件</translation>
    </message>
    <message>
        <source>this is a link or a pipe where a case's database keeps a file of its own</source>
        <translation>案件数据库存放自身文件的位置上是链接或管道</translation>
    </message>
    <message>
        <source>this is no SHA-256</source>
        <translation>这不是 SHA-256</translation>
    </message>
    <message>
        <source>this is no case database, or it is damaged</source>
        <translation>这不是案件数据库，或已损坏</translation>
    </message>
    <message>
        <source>this is no case of Vestige</source>
        <translation>这不是 Vestige 的案件</translation>
    </message>
    <message>
        <source>this is no end of a pair</source>
        <translation>这不是点对的端点</translation>
    </message>
    <message>
        <source>this is no first pose</source>
        <translation>这不是初始位姿</translation>
    </message>
    <message>
        <source>this is not JSON from byte %1 on</source>
        <translation>从第 %1 字节起不是 JSON</translation>
    </message>
    <message>
        <source>this is not below 0</source>
        <translation>此值不得小于 0</translation>
    </message>
    <message>
        <source>this journal names another file, which would be deleted</source>
        <translation>此日志指定了另一个文件，该文件将会被删除</translation>
    </message>
    <message>
        <source>this kind needs %1 points</source>
        <translation>此种类需要 %1 个点</translation>
    </message>
    <message>
        <source>this kind needs %1 points or more</source>
        <translation>此种类需要 %1 个或更多的点</translation>
    </message>
    <message>
        <source>this would replace a file of the layer '%1'</source>
        <translation>这将会覆盖图层“%1”的文件</translation>
    </message>
    <message>
        <source>two aims [{view, pixel, layers}, {...}]</source>
        <translation>两个点选 [{view, pixel, layers}, {...}]</translation>
    </message>
    <message>
        <source>two layers are called '%1'</source>
        <translation>有两个图层名为“%1”</translation>
    </message>
    <message>
        <source>two measurements are called '%1'</source>
        <translation>有两个测量名为“%1”</translation>
    </message>
    <message>
        <source>two objects are called '%1'</source>
        <translation>有两个物体名为“%1”</translation>
    </message>
    <message>
        <source>two saved views are called '%1'</source>
        <translation>有两个已保存的视图名为“%1”</translation>
    </message>
    <message>
        <source>undo the registration of layer '%1'</source>
        <translation>撤销图层“%1”的配准</translation>
    </message>
    <message>
        <source>view_up is zero or points along the direction of view</source>
        <translation>view_up 为零或与观察方向一致</translation>
    </message>
    <message>
        <source>wait until all of its points are read</source>
        <translation>请等到其全部点读取完毕</translation>
    </message>
</context>
<context>
    <name>ui/actions</name>
    <message>
        <source>&amp;About Vestige</source>
        <translation>关于 Vestige(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Add object</source>
        <translation>添加对象(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Blink</source>
        <translation>闪烁(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>仰视(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>方框(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Checkerboard</source>
        <translation>棋盘格(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Clean panel</source>
        <translation>清理面板(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Clear selection</source>
        <translation>清除选择(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Copy table</source>
        <translation>复制表格(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>距离(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Edge</source>
        <translation>边缘(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>英文(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Eye-dome lighting</source>
        <translation>眼穹光照(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Forget registration</source>
        <translation>取消配准(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Forget the part</source>
        <translation>从列表中去掉物体(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前视(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Highest</source>
        <translation>最高点(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史记录(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Horizontal distance</source>
        <translation>水平距离(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Import picks…</source>
        <translation>导入点选(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Invert selection</source>
        <translation>反向选择(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>轴测(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Keep only</source>
        <translation>仅保留所选(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Known distance</source>
        <translation>已知距离(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>套索(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Make object</source>
        <translation>设为物体(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measure panel</source>
        <translation>测量面板(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Move picks</source>
        <translation>移动点选(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;New case</source>
        <translation>新建案件(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Next snap</source>
        <translation>下一种捕捉(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>打开案件(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Orbit</source>
        <translation>环绕(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>正交投影(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透视(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Picks</source>
        <translation>点选(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Point to plane</source>
        <translation>点到平面(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Preview refused pose</source>
        <translation>预览被拒绝的位姿(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Register</source>
        <translation>配准(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Responsiveness</source>
        <translation>响应情况(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右视(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>保存案件(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Separate objects</source>
        <translation>分离物体(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Show all of it</source>
        <translation>显示全部(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Simplified Chinese</source>
        <translation>简体中文(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Smaller points</source>
        <translation>减小点(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Surface seen</source>
        <translation>所见表面(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Swipe</source>
        <translation>卷帘(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Target and source</source>
        <translation>目标与源(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Tint source and target</source>
        <translation>源与目标双色显示(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>教程(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Use this candidate</source>
        <translation>采用此候选位姿(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>用户指南(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Verify evidence</source>
        <translation>核验证据(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Vertical height</source>
        <translation>垂直高度(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Watch the fit</source>
        <translation>观察配准(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>A grid in metres, on the ground or over a plan.</source>
        <translation>以米为单位的网格，位于地面上或平面图上。</translation>
    </message>
    <message>
        <source>A magnified picture of the place that a click would take.</source>
        <translation>单击将选取位置的放大图。</translation>
    </message>
    <message>
        <source>A pick is the centre of the circle on whose rim it lies.</source>
        <translation>点选所在圆周的圆心。</translation>
    </message>
    <message>
        <source>A pick is the centroid of the points round it.</source>
        <translation>点选周围各点的质心。</translation>
    </message>
    <message>
        <source>A pick is the corner where three planes meet.</source>
        <translation>点选三个平面相交的角点。</translation>
    </message>
    <message>
        <source>A pick is the highest place of what lies round it.</source>
        <translation>点选附近的最高点。</translation>
    </message>
    <message>
        <source>A pick is the lowest place of what lies round it.</source>
        <translation>点选附近的最低点。</translation>
    </message>
    <message>
        <source>A pick is the measured point under the cursor.</source>
        <translation>点选光标下的测量点。</translation>
    </message>
    <message>
        <source>A pick lies on the edge where two planes meet.</source>
        <translation>点选位于两个平面相交的边缘上。</translation>
    </message>
    <message>
        <source>A pick lies on the plane through the points round it.</source>
        <translation>点选位于由其周围各点确定的平面上。</translation>
    </message>
    <message>
        <source>A pick lies where the line of sight meets the surface, the noise of its points averaged out.</source>
        <translation>点选位于视线与表面相交处，周围各点的噪声已平均掉。</translation>
    </message>
    <message>
        <source>A&amp;rc</source>
        <translation>圆弧(&amp;R)</translation>
    </message>
    <message>
        <source>Add an object to measure.</source>
        <translation>添加一个要测量的对象。</translation>
    </message>
    <message>
        <source>Add clo&amp;uds and meshes…</source>
        <translation>添加点云和网格(&amp;U)…</translation>
    </message>
    <message>
        <source>Add scans as layers: LAS, LAZ, PLY, PCD, OBJ, STL, VTK, text.</source>
        <translation>将扫描添加为图层：LAS、LAZ、PLY、PCD、OBJ、STL、VTK、文本。</translation>
    </message>
    <message>
        <source>Ali&amp;gn panel</source>
        <translation>对齐面板(&amp;G)</translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation>角度(&amp;G)</translation>
    </message>
    <message>
        <source>Ar&amp;ea</source>
        <translation>面积(&amp;E)</translation>
    </message>
    <message>
        <source>Arrows along the ways to move that the data do not hold.</source>
        <translation>用箭头显示数据未能约束的移动方式。</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>后视(&amp;K)</translation>
    </message>
    <message>
        <source>Back to the &amp;plain view</source>
        <translation>返回普通视图(&amp;P)</translation>
    </message>
    <message>
        <source>Before and &amp;after</source>
        <translation>之前与之后(&amp;A)</translation>
    </message>
    <message>
        <source>Begin an empty case.</source>
        <translation>开始一个空案件。</translation>
    </message>
    <message>
        <source>Bring back remo&amp;ved points</source>
        <translation>恢复已移除的点(&amp;V)</translation>
    </message>
    <message>
        <source>C&amp;ircle</source>
        <translation>圆(&amp;I)</translation>
    </message>
    <message>
        <source>C&amp;ircle centre</source>
        <translation>圆心(&amp;I)</translation>
    </message>
    <message>
        <source>C&amp;orner</source>
        <translation>角点(&amp;O)</translation>
    </message>
    <message>
        <source>Case an&amp;d report</source>
        <translation>案件与报告(&amp;D)</translation>
    </message>
    <message>
        <source>Cen&amp;troid</source>
        <translation>质心(&amp;T)</translation>
    </message>
    <message>
        <source>Choose the colours and from where to where they run.</source>
        <translation>选择颜色及其起止范围。</translation>
    </message>
    <message>
        <source>Clea&amp;n</source>
        <translation>清理(&amp;N)</translation>
    </message>
    <message>
        <source>Click a point, then three or more of a plane; the distance between them is measured.</source>
        <translation>单击一个点，再单击平面上的三个或更多点；测量两者之间的距离。</translation>
    </message>
    <message>
        <source>Click along a line, such as a skid mark; its length is measured.</source>
        <translation>沿一条线（例如制动印痕）单击；测量其长度。</translation>
    </message>
    <message>
        <source>Click along an arc, such as a yaw mark; its radius and, with a drag factor, the speed are found.</source>
        <translation>沿圆弧（例如侧滑印痕）单击；求得其半径，给出附着系数时还求得速度。</translation>
    </message>
    <message>
        <source>Click both ends of a line; the heights of the cloud along it are shown and measured.</source>
        <translation>单击一条线的两端；显示并测量点云沿该线的高程。</translation>
    </message>
    <message>
        <source>Click points of a rim; the diameter of the circle through them is measured.</source>
        <translation>单击圆周上的点；测量通过这些点的圆的直径。</translation>
    </message>
    <message>
        <source>Click round an outline; the area within is measured.</source>
        <translation>沿轮廓单击一圈；测量其中的面积。</translation>
    </message>
    <message>
        <source>Click round an outline; the space between the cloud and the plane through it is measured.</source>
        <translation>沿轮廓单击一圈；测量点云与通过该轮廓的平面之间的空间。</translation>
    </message>
    <message>
        <source>Click the two ends of an object; three repeats make a measurement.</source>
        <translation>单击对象的两个端点；重复三次构成一次测量。</translation>
    </message>
    <message>
        <source>Click three points of one plane and three or more of another; distance and angle are measured.</source>
        <translation>单击一个平面上的三个点和另一个平面上的三个或更多点；测量距离和夹角。</translation>
    </message>
    <message>
        <source>Click three points; the angle at the second is measured.</source>
        <translation>单击三个点；测量第二个点处的角度。</translation>
    </message>
    <message>
        <source>Click two points; the level part of the way between them is measured.</source>
        <translation>单击两个点；测量两点之间路径的水平分量。</translation>
    </message>
    <message>
        <source>Click two points; the upright part of the way between them is measured.</source>
        <translation>单击两个点；测量两点之间路径的竖直分量。</translation>
    </message>
    <message>
        <source>Click two undamaged ends, then along the damage; the depths C1 to C6 are measured.</source>
        <translation>单击两个未损坏的端点，再沿损坏部分单击；测量深度 C1 至 C6。</translation>
    </message>
    <message>
        <source>Click what an upright box is to reach; its length, width and height are measured.</source>
        <translation>单击直立长方体应到达的各点；测量其长、宽、高。</translation>
    </message>
    <message>
        <source>Close the program.</source>
        <translation>关闭程序。</translation>
    </message>
    <message>
        <source>Colour &amp;by layer</source>
        <translation>按图层着色(&amp;B)</translation>
    </message>
    <message>
        <source>Colour by &amp;RGB</source>
        <translation>按 RGB 着色(&amp;R)</translation>
    </message>
    <message>
        <source>Colour by &amp;class</source>
        <translation>按类别着色(&amp;C)</translation>
    </message>
    <message>
        <source>Colour by &amp;distance to target</source>
        <translation>按到目标的距离着色(&amp;D)</translation>
    </message>
    <message>
        <source>Colour by &amp;height</source>
        <translation>按高程着色(&amp;H)</translation>
    </message>
    <message>
        <source>Colour by i&amp;ntensity</source>
        <translation>按强度着色(&amp;N)</translation>
    </message>
    <message>
        <source>Colour points by their height.</source>
        <translation>按高程为点着色。</translation>
    </message>
    <message>
        <source>Colour registered layers by their distance to the target.</source>
        <translation>按到目标的距离为已配准的图层着色。</translation>
    </message>
    <message>
        <source>Colours and ran&amp;ge…</source>
        <translation>颜色与范围(&amp;G)…</translation>
    </message>
    <message>
        <source>Colours for ground, vegetation, buildings and the other classes that LAS files have.</source>
        <translation>地面、植被、建筑物以及 LAS 文件所含其他类别的颜色。</translation>
    </message>
    <message>
        <source>Compare registered layers at their first pose with where they lie now.</source>
        <translation>比较已配准图层的初始位姿与当前位置。</translation>
    </message>
    <message>
        <source>Compare the target alone with the other layers alone: what runs through both fits.</source>
        <translation>单独的目标与单独的其他图层相比较：贯穿两者的形体说明吻合。</translation>
    </message>
    <message>
        <source>Copy &amp;view</source>
        <translation>复制视图(&amp;V)</translation>
    </message>
    <message>
        <source>Copy the picture of the view to the clipboard.</source>
        <translation>将视图的图片复制到剪贴板。</translation>
    </message>
    <message>
        <source>Copy the selected rows of a table, or all of the measurements, with headings and units.</source>
        <translation>复制表格的所选行或全部测量结果，包括标题和单位。</translation>
    </message>
    <message>
        <source>Cr&amp;ush profile</source>
        <translation>变形断面(&amp;U)</translation>
    </message>
    <message>
        <source>Cross-&amp;section</source>
        <translation>断面(&amp;S)</translation>
    </message>
    <message>
        <source>Cut away t&amp;he inside</source>
        <translation>切除内部(&amp;H)</translation>
    </message>
    <message>
        <source>Displa&amp;y</source>
        <translation>显示(&amp;Y)</translation>
    </message>
    <message>
        <source>Do again what was undone.</source>
        <translation>重做已撤销的操作。</translation>
    </message>
    <message>
        <source>Drag the ends of the selected object, or nudge them with the arrow keys, without the measuring tool.</source>
        <translation>不用测量工具，拖动所选对象的端点，或用方向键微调。</translation>
    </message>
    <message>
        <source>Draw points larger.</source>
        <translation>将点画得更大。</translation>
    </message>
    <message>
        <source>Draw points smaller.</source>
        <translation>将点画得更小。</translation>
    </message>
    <message>
        <source>Each layer in its own tint.</source>
        <translation>每个图层用各自的颜色。</translation>
    </message>
    <message>
        <source>End the comparison, the replay or the preview.</source>
        <translation>结束比较、回放或预览。</translation>
    </message>
    <message>
        <source>Every step of the case; a click goes there.</source>
        <translation>案件的每一步；单击即转到该步。</translation>
    </message>
    <message>
        <source>Export &amp;measurements…</source>
        <translation>导出测量结果(&amp;M)…</translation>
    </message>
    <message>
        <source>Export &amp;report…</source>
        <translation>导出报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Export pic&amp;ks…</source>
        <translation>导出点选(&amp;K)…</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏(&amp;U)</translation>
    </message>
    <message>
        <source>Fill every view with all there is, or with the section.</source>
        <translation>使所有内容或剖切框充满每个视图。</translation>
    </message>
    <message>
        <source>Fill the view with the chosen part of the scene.</source>
        <translation>使所选的现场物体充满视图。</translation>
    </message>
    <message>
        <source>Fill the view with the selected layer, else with the one whose registration is described.</source>
        <translation>使所选图层充满视图，否则使所述配准的图层充满视图。</translation>
    </message>
    <message>
        <source>Fill the view with what was measured of the selected object.</source>
        <translation>让视图充满所选对象的测量部位。</translation>
    </message>
    <message>
        <source>Find &amp;ground</source>
        <translation>查找地面(&amp;G)</translation>
    </message>
    <message>
        <source>Find &amp;outliers</source>
        <translation>查找离群点(&amp;O)</translation>
    </message>
    <message>
        <source>Find where the selected layer belongs, whatever its first pose and unit, and register it there.</source>
        <translation>不论初始位姿和单位，查找所选图层所属的位置并在该处配准。</translation>
    </message>
    <message>
        <source>Fit &amp;quality</source>
        <translation>吻合质量(&amp;Q)</translation>
    </message>
    <message>
        <source>Fo&amp;ur views</source>
        <translation>四视图(&amp;U)</translation>
    </message>
    <message>
        <source>Forget the cleaning of the selected layer, or of all.</source>
        <translation>取消所选图层或所有图层的清理。</translation>
    </message>
    <message>
        <source>From above, from the front, from the left, and the view there was; a click makes one active.</source>
        <translation>俯视、前视、左视和原有视图；单击其一使其成为活动视图。</translation>
    </message>
    <message>
        <source>From scans to a report in ten minutes, on the sample case.</source>
        <translation>用示例案件在十分钟内从扫描做到报告。</translation>
    </message>
    <message>
        <source>Go back to the case as it was saved.</source>
        <translation>恢复到案件保存时的状态。</translation>
    </message>
    <message>
        <source>Grey by the strength of the return.</source>
        <translation>按回波强度显示灰度。</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>网格(&amp;D)</translation>
    </message>
    <message>
        <source>Hash every file again and compare with what was read (SHA-256).</source>
        <translation>重新计算每个文件的哈希值，并与读取时的值比较（SHA-256）。</translation>
    </message>
    <message>
        <source>Imp&amp;ort panel</source>
        <translation>导入面板(&amp;O)</translation>
    </message>
    <message>
        <source>Import ta&amp;pe values…</source>
        <translation>导入卷尺值(&amp;P)…</translation>
    </message>
    <message>
        <source>In perspective near points are drawn larger than far ones.</source>
        <translation>透视时近处的点画得比远处的大。</translation>
    </message>
    <message>
        <source>Keep this view in the case under a name, for you and the report.</source>
        <translation>将此视图以一个名称保存在案件中，供您和报告使用。</translation>
    </message>
    <message>
        <source>L&amp;arger points</source>
        <translation>增大点(&amp;A)</translation>
    </message>
    <message>
        <source>Left turns, middle or Shift and left move, wheel and right zoom.</source>
        <translation>左键旋转，中键或 Shift 加左键移动，滚轮和右键缩放。</translation>
    </message>
    <message>
        <source>Left turns, right moves, wheel and middle zoom.</source>
        <translation>左键旋转，右键移动，滚轮和中键缩放。</translation>
    </message>
    <message>
        <source>Left turns, right or middle moves, the wheel zooms.</source>
        <translation>左键旋转，右键或中键移动，滚轮缩放。</translation>
    </message>
    <message>
        <source>Light bac&amp;kground</source>
        <translation>浅色背景(&amp;K)</translation>
    </message>
    <message>
        <source>List what stands on the ground as objects: vehicles, debris, poles.</source>
        <translation>将立在地面上的东西列为物体：车辆、散落物、立杆。</translation>
    </message>
    <message>
        <source>Lo&amp;upe</source>
        <translation>放大镜(&amp;U)</translation>
    </message>
    <message>
        <source>Lo&amp;west</source>
        <translation>最低点(&amp;W)</translation>
    </message>
    <message>
        <source>Local p&amp;lane</source>
        <translation>局部平面(&amp;L)</translation>
    </message>
    <message>
        <source>Look &amp;at the part</source>
        <translation>查看物体(&amp;A)</translation>
    </message>
    <message>
        <source>Look at the la&amp;yer</source>
        <translation>查看图层(&amp;Y)</translation>
    </message>
    <message>
        <source>Look at the ob&amp;ject</source>
        <translation>查看对象(&amp;J)</translation>
    </message>
    <message>
        <source>Make layer the &amp;target</source>
        <translation>设为目标图层(&amp;T)</translation>
    </message>
    <message>
        <source>Make the section box hold all there is.</source>
        <translation>使剖切框容纳所有内容。</translation>
    </message>
    <message>
        <source>Measure how long the window takes to answer, and tell what held it longest.</source>
        <translation>测量窗口响应所需的时间，并指出什么占用窗口最久。</translation>
    </message>
    <message>
        <source>Measurements and their errors.</source>
        <translation>测量结果及其误差。</translation>
    </message>
    <message>
        <source>Mouse as in &amp;Vestige</source>
        <translation>鼠标操作同 Vestige(&amp;V)</translation>
    </message>
    <message>
        <source>Mouse as in C&amp;loudCompare</source>
        <translation>鼠标操作同 CloudCompare(&amp;L)</translation>
    </message>
    <message>
        <source>Mouse as in Slicer and F&amp;3D</source>
        <translation>鼠标操作同 Slicer 和 F3D(&amp;3)</translation>
    </message>
    <message>
        <source>Move the slab by its thickness against its axis.</source>
        <translation>将薄片逆其轴向移动一个厚度。</translation>
    </message>
    <message>
        <source>Move the slab by its thickness along its axis; Ctrl and wheel do so, too.</source>
        <translation>将薄片沿其轴向移动一个厚度；Ctrl 加滚轮亦可。</translation>
    </message>
    <message>
        <source>N&amp;orth arrow</source>
        <translation>指北针(&amp;O)</translation>
    </message>
    <message>
        <source>Name the selected points as an object of the scene.</source>
        <translation>将所选的点命名为现场物体。</translation>
    </message>
    <message>
        <source>Near &amp;points larger</source>
        <translation>近处的点较大(&amp;P)</translation>
    </message>
    <message>
        <source>Nearest &amp;point</source>
        <translation>最近点(&amp;P)</translation>
    </message>
    <message>
        <source>Open a case (case.json or .vestige).</source>
        <translation>打开案件（case.json 或 .vestige）。</translation>
    </message>
    <message>
        <source>Open sample &amp;case</source>
        <translation>打开示例案件(&amp;C)</translation>
    </message>
    <message>
        <source>Open the sample scene; where it is not there yet, it is simulated first (some minutes).</source>
        <translation>打开示例现场；尚不存在时先进行模拟（需数分钟）。</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, from any direction; off: perspective.</source>
        <translation>从任何方向看平行线都保持平行；关闭时：透视。</translation>
    </message>
    <message>
        <source>Picture of the vie&amp;w…</source>
        <translation>视图图片(&amp;W)…</translation>
    </message>
    <message>
        <source>Plane to pla&amp;ne</source>
        <translation>平面到平面(&amp;N)</translation>
    </message>
    <message>
        <source>Po&amp;lyline</source>
        <translation>折线(&amp;L)</translation>
    </message>
    <message>
        <source>Put the selected layer back to where its file has it.</source>
        <translation>将所选图层放回其文件所给的位置。</translation>
    </message>
    <message>
        <source>Reconstruct into a folder: PDF, CSV, pictures, fused cloud, manifest.</source>
        <translation>重建到文件夹：PDF、CSV、图片、融合点云、清单。</translation>
    </message>
    <message>
        <source>Register from &amp;any pose</source>
        <translation>从任意位姿配准(&amp;A)</translation>
    </message>
    <message>
        <source>Register the layer from the candidate that is chosen.</source>
        <translation>从所选的候选位姿配准图层。</translation>
    </message>
    <message>
        <source>Register the selected layer, or all that are not yet, to the target.</source>
        <translation>将所选图层或所有尚未配准的图层配准到目标。</translation>
    </message>
    <message>
        <source>Remove &amp;layer</source>
        <translation>移除图层(&amp;L)</translation>
    </message>
    <message>
        <source>Remove &amp;object</source>
        <translation>移除对象(&amp;O)</translation>
    </message>
    <message>
        <source>Remove last &amp;pick</source>
        <translation>移除最近的点选(&amp;P)</translation>
    </message>
    <message>
        <source>Reop&amp;en saved case</source>
        <translation>重新打开已保存的案件(&amp;E)</translation>
    </message>
    <message>
        <source>Resolve the clicks that the case recorded into picks.</source>
        <translation>将案件记录的单击解算为点选。</translation>
    </message>
    <message>
        <source>Sa&amp;ve view</source>
        <translation>保存视图(&amp;V)</translation>
    </message>
    <message>
        <source>Save a picture of the view, of any size or true to scale.</source>
        <translation>保存视图的图片，可为任意尺寸或按比例尺。</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>案件另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save shortcut &amp;sheet…</source>
        <translation>保存快捷键表(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the case under another name.</source>
        <translation>以其他名称保存案件。</translation>
    </message>
    <message>
        <source>Save the case where it came from.</source>
        <translation>将案件保存到原处。</translation>
    </message>
    <message>
        <source>Section bo&amp;x</source>
        <translation>剖切框(&amp;X)</translation>
    </message>
    <message>
        <source>Section round &amp;everything</source>
        <translation>剖切框包围全部(&amp;E)</translation>
    </message>
    <message>
        <source>Select &amp;points of the part</source>
        <translation>选择物体的点(&amp;P)</translation>
    </message>
    <message>
        <source>Select nothing.</source>
        <translation>不选择任何点。</translation>
    </message>
    <message>
        <source>Select points by a rectangle drawn over the view.</source>
        <translation>用在视图上画出的矩形选择点。</translation>
    </message>
    <message>
        <source>Select points by an outline drawn over the view.</source>
        <translation>用在视图上画出的轮廓选择点。</translation>
    </message>
    <message>
        <source>Select the points of the chosen part of the scene.</source>
        <translation>选择所选现场物体的点。</translation>
    </message>
    <message>
        <source>Select the points that lie apart from all others, of the selected layer or of all that are shown.</source>
        <translation>选择与所有其他点相分离的点，取自所选图层或所有显示的图层。</translation>
    </message>
    <message>
        <source>Select the surface that everything stands on, of the selected layer or else the target.</source>
        <translation>选择承载所有物体的表面，取自所选图层，否则取自目标图层。</translation>
    </message>
    <message>
        <source>Select what is shown and not selected.</source>
        <translation>选择已显示而未选择的点。</translation>
    </message>
    <message>
        <source>Selected ob&amp;ject</source>
        <translation>所选对象(&amp;J)</translation>
    </message>
    <message>
        <source>Shade edges so that shapes stand out.</source>
        <translation>加深边缘阴影，使形体突出。</translation>
    </message>
    <message>
        <source>Show &amp;before</source>
        <translation>显示配准前(&amp;B)</translation>
    </message>
    <message>
        <source>Show a thin level slab, across the z axis.</source>
        <translation>显示一层垂直于 z 轴的水平薄片。</translation>
    </message>
    <message>
        <source>Show a thin slab that faces the view: upright, from above level.</source>
        <translation>显示一层正对视图的薄片：竖直；从上方观察时为水平。</translation>
    </message>
    <message>
        <source>Show a thin slab upright across the x axis.</source>
        <translation>显示一层垂直于 x 轴的竖直薄片。</translation>
    </message>
    <message>
        <source>Show a thin slab upright across the y axis.</source>
        <translation>显示一层垂直于 y 轴的竖直薄片。</translation>
    </message>
    <message>
        <source>Show all shortcuts, and change them.</source>
        <translation>显示所有快捷键，并可更改。</translation>
    </message>
    <message>
        <source>Show each iteration of a registration in the view and as curves, and keep them to be replayed.</source>
        <translation>在视图中和以曲线显示配准的每次迭代，并保留以供回放。</translation>
    </message>
    <message>
        <source>Show fr&amp;ee directions</source>
        <translation>显示自由方向(&amp;E)</translation>
    </message>
    <message>
        <source>Show only what lies in a box, whose faces the mouse can drag; its bar has the figures.</source>
        <translation>只显示位于框内的内容，框的各面可用鼠标拖动；其数值在工具条中。</translation>
    </message>
    <message>
        <source>Show registered layers at their first pose.</source>
        <translation>显示已配准图层的初始位姿。</translation>
    </message>
    <message>
        <source>Show the layer one iteration earlier in its watched registration.</source>
        <translation>显示图层在所观察的配准中早一次迭代的位置。</translation>
    </message>
    <message>
        <source>Show the layer one iteration later in its watched registration.</source>
        <translation>显示图层在所观察的配准中晚一次迭代的位置。</translation>
    </message>
    <message>
        <source>Show the layer where a registration put it that cannot be relied on, without moving it.</source>
        <translation>显示不可信赖的配准将图层放到的位置，而不移动图层。</translation>
    </message>
    <message>
        <source>Show the target and the registered layers in two colours.</source>
        <translation>用两种颜色显示目标和已配准的图层。</translation>
    </message>
    <message>
        <source>Show the user guide beside the view.</source>
        <translation>在视图旁边显示用户指南。</translation>
    </message>
    <message>
        <source>Show what lies outside of the section box instead, as without a roof or a tree.</source>
        <translation>改为显示剖切框之外的部分，例如去掉屋顶或树木。</translation>
    </message>
    <message>
        <source>Show where y points, which is north on a map grid.</source>
        <translation>显示 y 轴的指向，在地图网格上即为北。</translation>
    </message>
    <message>
        <source>Slab &amp;1: across x</source>
        <translation>薄片(&amp;1)：垂直于 x</translation>
    </message>
    <message>
        <source>Slab &amp;2: across y</source>
        <translation>薄片(&amp;2)：垂直于 y</translation>
    </message>
    <message>
        <source>Slab &amp;3: level</source>
        <translation>薄片(&amp;3)：水平</translation>
    </message>
    <message>
        <source>Slab ba&amp;ck</source>
        <translation>薄片后移(&amp;C)</translation>
    </message>
    <message>
        <source>Slab facin&amp;g the view</source>
        <translation>正对视图的薄片(&amp;G)</translation>
    </message>
    <message>
        <source>Slab o&amp;n</source>
        <translation>薄片前移(&amp;N)</translation>
    </message>
    <message>
        <source>Snap picks to the next kind of feature.</source>
        <translation>将点选捕捉到下一种特征。</translation>
    </message>
    <message>
        <source>Take everything else of these layers out of the scene.</source>
        <translation>将这些图层的其余各点从现场中移除。</translation>
    </message>
    <message>
        <source>Take objects and what the tape says from a table, or from exported measurements.</source>
        <translation>从表格或导出的测量结果中取得对象及其卷尺值。</translation>
    </message>
    <message>
        <source>Take picked points from a list (x,y,z with index or label): each two are a repeat.</source>
        <translation>从列表取得点选的点（x,y,z，带索引或标签）：每两个点为一次测量。</translation>
    </message>
    <message>
        <source>Take points out of the scene, find the ground and what stands on it.</source>
        <translation>从现场中移除点，查找地面及地面上的物体。</translation>
    </message>
    <message>
        <source>Take recorded &amp;aims</source>
        <translation>采用记录的点选(&amp;A)</translation>
    </message>
    <message>
        <source>Take the chosen part out of the list; its points stay.</source>
        <translation>将所选物体从列表中去掉；其点保留。</translation>
    </message>
    <message>
        <source>Take the last change of the case back.</source>
        <translation>撤回对案件的最后一次更改。</translation>
    </message>
    <message>
        <source>Take the selected layer out of the case.</source>
        <translation>将所选图层从案件中移除。</translation>
    </message>
    <message>
        <source>Take the selected object out of the table.</source>
        <translation>将所选对象从表中移除。</translation>
    </message>
    <message>
        <source>Take the selected object's last repeat away.</source>
        <translation>移除所选对象的最后一次测量。</translation>
    </message>
    <message>
        <source>Take the selected points out of the scene; the file keeps them.</source>
        <translation>将所选的点从现场中移除；文件仍保留这些点。</translation>
    </message>
    <message>
        <source>The case's details, what is missing, and what a report writes.</source>
        <translation>案件信息、缺少的内容以及报告将写出的内容。</translation>
    </message>
    <message>
        <source>The colours that the files have.</source>
        <translation>文件自带的颜色。</translation>
    </message>
    <message>
        <source>The files of the case and what they are.</source>
        <translation>案件的文件及其标识。</translation>
    </message>
    <message>
        <source>The kind of the selected object, its figures and what their uncertainty is made of.</source>
        <translation>所选对象的类型、数值及其不确定度的构成。</translation>
    </message>
    <message>
        <source>The other layers are registered to this one.</source>
        <translation>其他图层配准到此图层。</translation>
    </message>
    <message>
        <source>The selected object is a known distance that the survey is checked by; its tape value is the reference.</source>
        <translation>所选对象是用于核验勘测的已知距离；其卷尺值为参考值。</translation>
    </message>
    <message>
        <source>The view turns about the point under the cursor; where there is none, about what is dragged.</source>
        <translation>视图绕光标下的点旋转；该处没有点时，绕所拖动之处旋转。</translation>
    </message>
    <message>
        <source>Turn about the point un&amp;der the cursor</source>
        <translation>绕光标下的点旋转(&amp;D)</translation>
    </message>
    <message>
        <source>Turn, move and zoom the view.</source>
        <translation>旋转、平移和缩放视图。</translation>
    </message>
    <message>
        <source>Two pictures beside a divider that the mouse drags; Left and Right move it, too.</source>
        <translation>两幅画面由可用鼠标拖动的分隔线分开；左、右方向键也可移动它。</translation>
    </message>
    <message>
        <source>Two pictures in tiles; Left and Right change their size.</source>
        <translation>两幅画面以方格相间；左、右方向键改变其大小。</translation>
    </message>
    <message>
        <source>Two pictures in turn; Left and Right change the speed, Space holds one.</source>
        <translation>两幅画面轮流显示；左、右方向键改变速度，空格键停住一幅。</translation>
    </message>
    <message>
        <source>Use the whole screen, or go back.</source>
        <translation>使用整个屏幕，或恢复原状。</translation>
    </message>
    <message>
        <source>Version and what it is built with.</source>
        <translation>版本及所用组件。</translation>
    </message>
    <message>
        <source>View the scene from above.</source>
        <translation>从上方观察现场。</translation>
    </message>
    <message>
        <source>View the scene from below.</source>
        <translation>从下方观察现场。</translation>
    </message>
    <message>
        <source>View the scene from the back.</source>
        <translation>从后方观察现场。</translation>
    </message>
    <message>
        <source>View the scene from the front.</source>
        <translation>从前方观察现场。</translation>
    </message>
    <message>
        <source>View the scene from the left.</source>
        <translation>从左侧观察现场。</translation>
    </message>
    <message>
        <source>View the scene from the right.</source>
        <translation>从右侧观察现场。</translation>
    </message>
    <message>
        <source>View the scene in perspective.</source>
        <translation>以透视方式观察现场。</translation>
    </message>
    <message>
        <source>View the scene obliquely from above.</source>
        <translation>从斜上方观察现场。</translation>
    </message>
    <message>
        <source>Volu&amp;me</source>
        <translation>体积(&amp;M)</translation>
    </message>
    <message>
        <source>Watched iteration bac&amp;k</source>
        <translation>上一次所观察的迭代(&amp;K)</translation>
    </message>
    <message>
        <source>Watched iteration o&amp;n</source>
        <translation>下一次所观察的迭代(&amp;N)</translation>
    </message>
    <message>
        <source>What a registration depends on.</source>
        <translation>配准所依据的参数。</translation>
    </message>
    <message>
        <source>What the last registration says of itself: verdict, uncertainty, residuals, iterations.</source>
        <translation>最近一次配准对自身的说明：评定、不确定度、残差、迭代。</translation>
    </message>
    <message>
        <source>Window and pictures dark on light, for paper, projectors and bright rooms.</source>
        <translation>窗口和图片为浅底深字，适用于打印、投影和明亮的房间。</translation>
    </message>
    <message>
        <source>Window, messages and reports in English.</source>
        <translation>窗口、消息和报告用英文。</translation>
    </message>
    <message>
        <source>Window, messages and reports in Simplified Chinese.</source>
        <translation>窗口、消息和报告用简体中文。</translation>
    </message>
    <message>
        <source>Write all picked points as label,x,y,z, which reads back.</source>
        <translation>将所有点选的点写为 label,x,y,z，可重新读入。</translation>
    </message>
    <message>
        <source>Write the shortcuts as a page to print: PDF, HTML or text.</source>
        <translation>将快捷键写成可打印的页面：PDF、HTML 或文本。</translation>
    </message>
    <message>
        <source>Write the table of measurements as CSV.</source>
        <translation>将测量结果表写为 CSV。</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>expected a name that ends with .pdf, .html or .txt</source>
        <translation>应为以 .pdf、.html 或 .txt 结尾的名称</translation>
    </message>
    <message>
        <source>first pose of %1</source>
        <translation>%1 的初始位姿</translation>
    </message>
    <message>
        <source>register %1</source>
        <translation>配准 %1</translation>
    </message>
    <message>
        <source>take recorded aims</source>
        <translation>采用记录的点选</translation>
    </message>
    <message>
        <source>the folder of the sample case cannot be made</source>
        <translation>无法创建示例案件的文件夹</translation>
    </message>
    <message>
        <source>this is no name of a sheet</source>
        <translation>这不是快捷键表的名称</translation>
    </message>
</context>
<context>
    <name>ui/charts</name>
    <message>
        <source>excluded (hollow)</source>
        <translation>已剔除（空心）</translation>
    </message>
    <message>
        <source>n/m</source>
        <translation>未测</translation>
    </message>
</context>
<context>
    <name>ui/document</name>
    <message>
        <source>Hashing %1</source>
        <translation>正在计算 %1 的哈希值</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>it is saved when the disk answers</source>
        <translation>磁盘响应后即会保存</translation>
    </message>
    <message>
        <source>its changes are recovered as a case without a place</source>
        <translation>其更改恢复为没有存放位置的案件</translation>
    </message>
    <message>
        <source>load a part of %1</source>
        <translation>载入 %1 的一部分</translation>
    </message>
    <message>
        <source>load what is whole of %1</source>
        <translation>载入 %1 中完好的部分</translation>
    </message>
    <message>
        <source>note what the file is</source>
        <translation>记下文件的标识</translation>
    </message>
    <message>
        <source>nothing was saved; try again later, or save under another name</source>
        <translation>未保存任何内容；请稍后再试，或以其他名称保存</translation>
    </message>
    <message>
        <source>recover unsaved changes</source>
        <translation>恢复未保存的更改</translation>
    </message>
    <message>
        <source>the disk has not yet taken the case</source>
        <translation>磁盘尚未写入案件</translation>
    </message>
    <message>
        <source>the disk has not yet taken the changes that were made before</source>
        <translation>磁盘尚未写入此前所作的更改</translation>
    </message>
    <message>
        <source>undo %1</source>
        <translation>撤销 %1</translation>
    </message>
</context>
<context>
    <name>ui/panels</name>
    <message>
        <source>role of %1</source>
        <translation>%1 的类型</translation>
    </message>
    <message>
        <source>start of %1</source>
        <translation>%1 的起点</translation>
    </message>
    <message>
        <source>unit of %1</source>
        <translation>%1 的单位</translation>
    </message>
</context>
<context>
    <name>ui/print</name>
    <message>
        <source>%1 (continued)</source>
        <translation>%1（续）</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案件</translation>
    </message>
    <message>
        <source>Made with</source>
        <translation>制作软件</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>报告日期</translation>
    </message>
    <message>
        <source>a chart cannot be written in this format</source>
        <translation>图表不能以此格式写出</translation>
    </message>
    <message>
        <source>expected .png or .svg</source>
        <translation>应为 .png 或 .svg</translation>
    </message>
    <message>
        <source>report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>the PDF cannot be begun</source>
        <translation>无法开始写 PDF</translation>
    </message>
    <message>
        <source>the PDF cannot be finished</source>
        <translation>无法完成 PDF</translation>
    </message>
    <message>
        <source>the PNG cannot be made</source>
        <translation>无法生成 PNG</translation>
    </message>
    <message>
        <source>the SVG cannot be begun</source>
        <translation>无法开始写 SVG</translation>
    </message>
    <message>
        <source>the picture cannot be read</source>
        <translation>无法读取图片</translation>
    </message>
</context>
<context>
    <name>ui/shell</name>
    <message>
        <source>drawing %1</source>
        <translation>正在绘制 %1</translation>
    </message>
</context>
<context>
    <name>ui/view</name>
    <message>
        <source> (target)</source>
        <translation>（目标）</translation>
    </message>
    <message>
        <source>%1 at %2 dpi</source>
        <translation>%1，%2 dpi</translation>
    </message>
    <message>
        <source>+ above or outside, − below or inside</source>
        <translation>+ 在上方或外侧，− 在下方或内侧</translation>
    </message>
    <message>
        <source>, no classes</source>
        <translation>，无类别</translation>
    </message>
    <message>
        <source>, no colour</source>
        <translation>，无颜色</translation>
    </message>
    <message>
        <source>, no intensity</source>
        <translation>，无强度</translation>
    </message>
    <message>
        <source>1 to %1 a side, %2 million in all</source>
        <translation>每边应为 1 到 %1，总计不超过 %2 百万</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Distance to the target's surface</source>
        <translation>到目标表面的距离</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Grey: each layer's own range of intensity</source>
        <translation>灰度：各图层自身的强度范围</translation>
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
        <source>Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>PointClass</source>
        <translation>点类别</translation>
    </message>
    <message>
        <source>Range as typed; the spread is %1 %2 (1 SD)</source>
        <translation>范围按所输入的值；离散度为 %1 %2（1 倍标准差）</translation>
    </message>
    <message>
        <source>Range: 3 × the spread of %1 %2 (1 SD)</source>
        <translation>范围：%1 %2 离散度（1 倍标准差）的 3 倍</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Tiles: %1 and %2 in turn, %1 at the top left; faint where a tile's own is empty</source>
        <translation>方格：%1与%2相间，左上角为%1；方格自身无内容处显示较淡</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels cannot be drawn</source>
        <translation>无法绘制 %1 x %2 像素的图片</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>按记录值</translation>
    </message>
    <message>
        <source>at the view's centre</source>
        <translation>视图中心处</translation>
    </message>
    <message>
        <source>bridge deck</source>
        <translation>桥面</translation>
    </message>
    <message>
        <source>grid %1</source>
        <translation>网格 %1</translation>
    </message>
    <message>
        <source>high noise</source>
        <translation>高处噪声</translation>
    </message>
    <message>
        <source>high vegetation</source>
        <translation>高植被</translation>
    </message>
    <message>
        <source>ignored ground</source>
        <translation>忽略的地面</translation>
    </message>
    <message>
        <source>low noise</source>
        <translation>低处噪声</translation>
    </message>
    <message>
        <source>low vegetation</source>
        <translation>低植被</translation>
    </message>
    <message>
        <source>medium vegetation</source>
        <translation>中等植被</translation>
    </message>
    <message>
        <source>model key point</source>
        <translation>模型关键点</translation>
    </message>
    <message>
        <source>never classified</source>
        <translation>从未分类</translation>
    </message>
    <message>
        <source>no off-screen drawing context</source>
        <translation>没有离屏绘图环境</translation>
    </message>
    <message>
        <source>no surface of the target there</source>
        <translation>该处没有目标表面</translation>
    </message>
    <message>
        <source>of the user</source>
        <translation>用户定义</translation>
    </message>
    <message>
        <source>overhead structure</source>
        <translation>高架结构</translation>
    </message>
    <message>
        <source>road surface</source>
        <translation>路面</translation>
    </message>
    <message>
        <source>temporal exclusion</source>
        <translation>时间排除点</translation>
    </message>
    <message>
        <source>the picture could not be drawn</source>
        <translation>无法绘制图片</translation>
    </message>
    <message>
        <source>the picture could not be packed as PNG</source>
        <translation>无法将图片压缩为 PNG</translation>
    </message>
    <message>
        <source>this machine gives no OpenGL 3.2 context to draw pictures with</source>
        <translation>本机没有提供绘制图片所需的 OpenGL 3.2 环境</translation>
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
        <source>wire, conductor</source>
        <translation>导线（相线）</translation>
    </message>
    <message>
        <source>wire, guard</source>
        <translation>架空地线</translation>
    </message>
</context>
<context>
    <name>vocabulary</name>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>east-west</source>
        <translation>东西</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>微米</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>north-south</source>
        <translation>南北</translation>
    </message>
    <message>
        <source>northeast-southwest</source>
        <translation>东北-西南</translation>
    </message>
    <message>
        <source>southeast-northwest</source>
        <translation>东南-西北</translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>%1 April %2</source>
        <translation>%2 年 4 月 %1 日</translation>
    </message>
    <message>
        <source>%1 April %2, %3 UTC</source>
        <translation>%2 年 4 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 August %2</source>
        <translation>%2 年 8 月 %1 日</translation>
    </message>
    <message>
        <source>%1 August %2, %3 UTC</source>
        <translation>%2 年 8 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 December %2</source>
        <translation>%2 年 12 月 %1 日</translation>
    </message>
    <message>
        <source>%1 December %2, %3 UTC</source>
        <translation>%2 年 12 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 February %2</source>
        <translation>%2 年 2 月 %1 日</translation>
    </message>
    <message>
        <source>%1 February %2, %3 UTC</source>
        <translation>%2 年 2 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 January %2</source>
        <translation>%2 年 1 月 %1 日</translation>
    </message>
    <message>
        <source>%1 January %2, %3 UTC</source>
        <translation>%2 年 1 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 July %2</source>
        <translation>%2 年 7 月 %1 日</translation>
    </message>
    <message>
        <source>%1 July %2, %3 UTC</source>
        <translation>%2 年 7 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 June %2</source>
        <translation>%2 年 6 月 %1 日</translation>
    </message>
    <message>
        <source>%1 June %2, %3 UTC</source>
        <translation>%2 年 6 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 March %2</source>
        <translation>%2 年 3 月 %1 日</translation>
    </message>
    <message>
        <source>%1 March %2, %3 UTC</source>
        <translation>%2 年 3 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 May %2</source>
        <translation>%2 年 5 月 %1 日</translation>
    </message>
    <message>
        <source>%1 May %2, %3 UTC</source>
        <translation>%2 年 5 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 November %2</source>
        <translation>%2 年 11 月 %1 日</translation>
    </message>
    <message>
        <source>%1 November %2, %3 UTC</source>
        <translation>%2 年 11 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 October %2</source>
        <translation>%2 年 10 月 %1 日</translation>
    </message>
    <message>
        <source>%1 October %2, %3 UTC</source>
        <translation>%2 年 10 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>%1 September %2</source>
        <translation>%2 年 9 月 %1 日</translation>
    </message>
    <message>
        <source>%1 September %2, %3 UTC</source>
        <translation>%2 年 9 月 %1 日 %3 (UTC)</translation>
    </message>
    <message>
        <source>Compiler</source>
        <translation>编译器</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Open the window again in English</source>
        <translation>以中文重新打开窗口</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Vestige speaks English from its next start on.</source>
        <translation>Vestige 将从下次启动起使用中文。</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>可接受</translation>
    </message>
    <message>
        <source>aerial</source>
        <translation>航测</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>不唯一</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>classification</source>
        <translation>分类</translation>
    </message>
    <message>
        <source>color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>crush</source>
        <translation>变形量</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>expected a number %1</source>
        <translation>应为一个数，%1</translation>
    </message>
    <message>
        <source>expected a whole number %1</source>
        <translation>应为一个整数，%1</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>false</source>
        <translation>否</translation>
    </message>
    <message>
        <source>from %1 up to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>from %1 up to %2 (%3)</source>
        <translation>%1 到 %2（%3）</translation>
    </message>
    <message>
        <source>from %1 up to %2 (%3), or auto</source>
        <translation>%1 到 %2（%3），或 auto</translation>
    </message>
    <message>
        <source>from %1 up to %2, or auto</source>
        <translation>%1 到 %2，或 auto</translation>
    </message>
    <message>
        <source>gps_time</source>
        <translation>GPS 时间</translation>
    </message>
    <message>
        <source>handheld</source>
        <translation>手持</translation>
    </message>
    <message>
        <source>highest</source>
        <translation>最高点</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平距离</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>lidar</source>
        <translation>激光扫描</translation>
    </message>
    <message>
        <source>lowest</source>
        <translation>最低点</translation>
    </message>
    <message>
        <source>more</source>
        <translation>更远</translation>
    </message>
    <message>
        <source>moves up and down and tilts about a level axis that runs %1</source>
        <translation>上下移动并绕%1方向的水平轴倾斜</translation>
    </message>
    <message>
        <source>moves up and down and turns about a sloping axis that runs %1</source>
        <translation>上下移动并绕%1方向的倾斜轴转动</translation>
    </message>
    <message>
        <source>moves up and down and turns about the vertical axis</source>
        <translation>上下移动并绕竖直轴转动</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>normals</source>
        <translation>法向量</translation>
    </message>
    <message>
        <source>number_of_returns</source>
        <translation>回波总数</translation>
    </message>
    <message>
        <source>one of every %1 points of %2</source>
        <translation>%2，每 %1 个点取一个</translation>
    </message>
    <message>
        <source>photogrammetry</source>
        <translation>摄影测量</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>plane-to-plane</source>
        <translation>面到面</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>point-to-plane</source>
        <translation>点到面</translation>
    </message>
    <message>
        <source>point_source</source>
        <translation>点源</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>polyline</source>
        <translation>折线</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>return_number</source>
        <translation>回波序号</translation>
    </message>
    <message>
        <source>set</source>
        <translation>已设定</translation>
    </message>
    <message>
        <source>slides at a slope %1 and tilts about a level axis that runs %2</source>
        <translation>沿%1方向斜向滑动并绕%2方向的水平轴倾斜</translation>
    </message>
    <message>
        <source>slides at a slope %1 and turns about a sloping axis that runs %2</source>
        <translation>沿%1方向斜向滑动并绕%2方向的倾斜轴转动</translation>
    </message>
    <message>
        <source>slides at a slope %1 and turns about the vertical axis</source>
        <translation>沿%1方向斜向滑动并绕竖直轴转动</translation>
    </message>
    <message>
        <source>slides level %1 and tilts about a level axis that runs %2</source>
        <translation>沿%1方向水平滑动并绕%2方向的水平轴倾斜</translation>
    </message>
    <message>
        <source>slides level %1 and turns about a sloping axis that runs %2</source>
        <translation>沿%1方向水平滑动并绕%2方向的倾斜轴转动</translation>
    </message>
    <message>
        <source>slides level %1 and turns about the vertical axis</source>
        <translation>沿%1方向水平滑动并绕竖直轴转动</translation>
    </message>
    <message>
        <source>true</source>
        <translation>是</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>垂直距离</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
</context>
</TS>
