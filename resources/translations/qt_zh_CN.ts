<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>QPlatformTheme</name>
    <message><source>OK</source><translation>确定</translation></message>
    <message><source>Save</source><translation>保存</translation></message>
    <message><source>Open</source><translation>打开</translation></message>
    <message><source>&amp;Yes</source><translation>是(&amp;Y)</translation></message>
    <message><source>&amp;No</source><translation>否(&amp;N)</translation></message>
    <message><source>Cancel</source><translation>取消</translation></message>
    <message><source>Close</source><translation>关闭</translation></message>
    <message><source>Discard</source><translation>不保存</translation></message>
    <message><source>Don't Save</source><translation>不保存</translation></message>
    <message><source>Reset</source><translation>重置</translation></message>
    <message><source>Apply</source><translation>应用</translation></message>
    <message><source>Help</source><translation>帮助</translation></message>
</context>
<context>
    <name>QFileDialog</name>
    <message><source>Look in:</source><translation>查找位置：</translation></message>
    <message><source>Back</source><translation>后退</translation></message>
    <message><source>Go back</source><translation>后退</translation></message>
    <message><source>Forward</source><translation>前进</translation></message>
    <message><source>Go forward</source><translation>前进</translation></message>
    <message><source>Parent Directory</source><translation>上级文件夹</translation></message>
    <message><source>Go to the parent directory</source><translation>转到上级文件夹</translation></message>
    <message><source>Create New Folder</source><translation>新建文件夹</translation></message>
    <message><source>Create a New Folder</source><translation>新建文件夹</translation></message>
    <message><source>List View</source><translation>列表</translation></message>
    <message><source>Change to list view mode</source><translation>以列表显示</translation></message>
    <message><source>Detail View</source><translation>详细信息</translation></message>
    <message><source>Change to detail view mode</source><translation>显示详细信息</translation></message>
    <message><source>Sidebar</source><translation>侧栏</translation></message>
    <message><source>List of places and bookmarks</source><translation>位置和书签列表</translation></message>
    <message><source>Files</source><translation>文件</translation></message>
    <message><source>Files of type:</source><translation>文件类型：</translation></message>
    <message><source>Directory:</source><translation>文件夹：</translation></message>
    <message><source>File &amp;name:</source><translation>文件名(&amp;N)：</translation></message>
    <message><source>&amp;Open</source><translation>打开(&amp;O)</translation></message>
    <message><source>&amp;Save</source><translation>保存(&amp;S)</translation></message>
    <message><source>Save As</source><translation>另存为</translation></message>
    <message><source>&amp;Choose</source><translation>选择(&amp;C)</translation></message>
    <message><source>&amp;Rename</source><translation>重命名(&amp;R)</translation></message>
    <message><source>&amp;Delete</source><translation>删除(&amp;D)</translation></message>
    <message><source>Show &amp;hidden files</source><translation>显示隐藏文件(&amp;H)</translation></message>
    <message><source>&amp;New Folder</source><translation>新建文件夹(&amp;N)</translation></message>
    <message><source>Recent Places</source><translation>最近的位置</translation></message>
    <message><source>My Computer</source><translation>计算机</translation></message>
    <message><source>Find Directory</source><translation>查找文件夹</translation></message>
    <message><source>Open</source><translation>打开</translation></message>
    <message><source>All Files (*)</source><translation>所有文件 (*)</translation></message>
    <message><source>%1 already exists.
Do you want to replace it?</source><translation>%1 已存在。
是否替换？</translation></message>
    <message><source>%1
File not found.
Please verify the correct file name was given.</source><translation>%1
找不到文件。
请检查文件名是否正确。</translation></message>
    <message><source>%1
Directory not found.
Please verify the correct directory name was given.</source><translation>%1
找不到文件夹。
请检查文件夹名是否正确。</translation></message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message><source>Name</source><translation>名称</translation></message>
    <message><source>Size</source><translation>大小</translation></message>
    <message><source>Type</source><translation>类型</translation></message>
    <message><source>Date Modified</source><translation>修改日期</translation></message>
    <message><source>Computer</source><translation>计算机</translation></message>
    <message><source>%1 bytes</source><translation>%1 字节</translation></message>
</context>
<context>
    <name>QLineEdit</name>
    <message><source>&amp;Undo</source><translation>撤销(&amp;U)</translation></message>
    <message><source>&amp;Redo</source><translation>重做(&amp;R)</translation></message>
    <message><source>Cu&amp;t</source><translation>剪切(&amp;T)</translation></message>
    <message><source>&amp;Copy</source><translation>复制(&amp;C)</translation></message>
    <message><source>&amp;Paste</source><translation>粘贴(&amp;P)</translation></message>
    <message><source>Select All</source><translation>全选</translation></message>
    <message><source>Delete</source><translation>删除</translation></message>
</context>
<context>
    <name>QTabBar</name>
    <message><source>Scroll Left</source><translation>向左滚动</translation></message>
    <message><source>Scroll Right</source><translation>向右滚动</translation></message>
</context>
</TS>
