<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AlertRules</name>
    <message>
        <source>emergency</source>
        <translation>紧急</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>警报</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>caution</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>last heard %1 ago</source>
        <translation>%1前最后收到</translation>
    </message>
    <message>
        <source>never heard</source>
        <translation>从未收到</translation>
    </message>
    <message>
        <source>Link to the tracker lost</source>
        <translation>与跟踪器的链路中断</translation>
    </message>
    <message>
        <source>Tracker is quiet</source>
        <translation>跟踪器无数据</translation>
    </message>
    <message>
        <source>Link to the sonar lost</source>
        <translation>与声纳的链路中断</translation>
    </message>
    <message>
        <source>Sonar is quiet</source>
        <translation>声纳无数据</translation>
    </message>
    <message>
        <source>The sonar head needs a look</source>
        <translation>声纳头需要检查</translation>
    </message>
    <message>
        <source>tracks coast until it is back</source>
        <translation>恢复前航迹外推</translation>
    </message>
    <message>
        <source>Heading old, limit %1</source>
        <translation>艏向过旧，限值 %1</translation>
    </message>
    <message>
        <source>No heading</source>
        <translation>无艏向</translation>
    </message>
    <message>
        <source>Recording has ended</source>
        <translation>记录已停止</translation>
    </message>
    <message>
        <source>make room and connect again</source>
        <translation>请清理磁盘后重新连接</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>剩余 %1</translation>
    </message>
    <message>
        <source>Disk nearly full</source>
        <translation>磁盘将满</translation>
    </message>
    <message>
        <source>room for %1 min</source>
        <translation>还可记录 %1 分钟</translation>
    </message>
    <message>
        <source>%1 lost, no echo for %2</source>
        <translation>%1 丢失，%2 无回波</translation>
    </message>
    <message>
        <source>expected at %1 %2</source>
        <translation>预计位于 %1 %2</translation>
    </message>
    <message>
        <source>%1 in guard zone %2</source>
        <translation>%1 进入警戒区 %2</translation>
    </message>
    <message>
        <source>a confirmed track has come in</source>
        <translation>已确认的航迹进入</translation>
    </message>
    <message>
        <source>The run is not copied here</source>
        <translation>本次运行未复制到本机</translation>
    </message>
</context>
<context>
    <name>EchoMap</name>
    <message>
        <source>bronze</source>
        <translation>青铜</translation>
    </message>
    <message>
        <source>viridis</source>
        <translation>viridis</translation>
    </message>
    <message>
        <source>cividis</source>
        <translation>cividis</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>灰度</translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>Day</source>
        <translation>白天</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>夜间</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>黄昏</translation>
    </message>
</context>
<context>
    <name>TrackReasons</name>
    <message>
        <source>%1 of %2 echoes, existence %3 of %4</source>
        <translation>回波 %1/%2，存在概率 %3/%4</translation>
    </message>
    <message>
        <source>%1 echoes; lost after %2 looks without</source>
        <translation>%1 次回波；连续 %2 次无回波即丢失</translation>
    </message>
    <message>
        <source>%1 of %2 looks without an echo</source>
        <translation>%1/%2 次观测无回波</translation>
    </message>
    <message>
        <source>lost: %1 looks without an echo, limit %2</source>
        <translation>丢失：%1 次观测无回波，限值 %2</translation>
    </message>
    <message>
        <source>lost: existence %1 below %2</source>
        <translation>丢失：存在概率 %1 低于 %2</translation>
    </message>
    <message>
        <source>lost: no echo for %1, limit %2</source>
        <translation>丢失：%1 无回波，限值 %2</translation>
    </message>
    <message>
        <source>%1, %2 ago, from an unclaimed echo</source>
        <translation>%1，%2前，由无主回波产生</translation>
    </message>
    <message>
        <source>no region within %1</source>
        <translation>%1 内无区域</translation>
    </message>
    <message>
        <source>R%1 %2 at %3</source>
        <translation>R%1 %2 距 %3</translation>
    </message>
    <message>
        <source>the sector leaves it out</source>
        <translation>扇区未包含其位置</translation>
    </message>
    <message>
        <source>the beam has not come by</source>
        <translation>波束尚未扫到</translation>
    </message>
    <message>
        <source>nothing stood out</source>
        <translation>没有超过阈值的回波</translation>
    </message>
    <message>
        <source>run into something larger</source>
        <translation>并入更大的回波</translation>
    </message>
    <message>
        <source>what was there is another track&apos;s</source>
        <translation>该处回波属于其他航迹</translation>
    </message>
    <message>
        <source>what was there is more likely clutter</source>
        <translation>该处回波更像杂波</translation>
    </message>
    <message>
        <source>navigation was missing</source>
        <translation>缺少导航</translation>
    </message>
    <message>
        <source>pings were missing</source>
        <translation>缺少 ping</translation>
    </message>
    <message>
        <source>outside the sector</source>
        <translation>扇区之外</translation>
    </message>
    <message>
        <source>not yet scanned</source>
        <translation>尚未扫描</translation>
    </message>
    <message>
        <source>under the threshold</source>
        <translation>低于阈值</translation>
    </message>
    <message>
        <source>merged with clutter</source>
        <translation>与杂波合并</translation>
    </message>
    <message>
        <source>taken by another track</source>
        <translation>被其他航迹占用</translation>
    </message>
    <message>
        <source>out-scored by clutter</source>
        <translation>得分低于杂波</translation>
    </message>
    <message>
        <source>navigation gap</source>
        <translation>导航中断</translation>
    </message>
    <message>
        <source>pings missing</source>
        <translation>缺少 ping</translation>
    </message>
    <message>
        <source>cause not told</source>
        <translation>原因未知</translation>
    </message>
    <message>
        <source>%1 of %1 with an echo</source>
        <translation>%1/%1 次有回波</translation>
    </message>
    <message>
        <source>%1 of %2 without an echo</source>
        <translation>%1/%2 次无回波</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 次%2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>until lost, %1 of %2 without an echo</source>
        <translation>丢失前 %1/%2 次无回波</translation>
    </message>
</context>
<context>
    <name>TrackStrips</name>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>NIS, 95 % 5.99</source>
        <translation>NIS，95 % 5.99</translation>
    </message>
    <message>
        <source>Missed, 20 %</source>
        <translation>漏测，20 %</translation>
    </message>
    <message>
        <source>Range m</source>
        <translation>距离 m</translation>
    </message>
    <message>
        <source>Bearing °R</source>
        <translation>舷角 °R</translation>
    </message>
</context>
<context>
    <name>echotrail::AlertCentre</name>
    <message>
        <source>Alerts cannot be written to %1. They are only shown.</source>
        <translation>告警无法写入 %1，仅显示。</translation>
    </message>
</context>
<context>
    <name>echotrail::AlertDelegate</name>
    <message>
        <source>Ack</source>
        <translation>确认</translation>
    </message>
</context>
<context>
    <name>echotrail::AlertModel</name>
    <message>
        <source>not acknowledged</source>
        <translation>未确认</translation>
    </message>
    <message>
        <source>over</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>lasting</source>
        <translation>持续中</translation>
    </message>
</context>
<context>
    <name>echotrail::AlertsPanel</name>
    <message>
        <source>Alerts</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>No alerts. Lost targets, broken links, missing headings and a full disk are listed here.</source>
        <translation>无告警。目标丢失、链路中断、艏向缺失、磁盘已满将在此列出。</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>The alert at the top of the list (A); Enter: the selected one</source>
        <translation>列表最上面的告警 (A)；Enter：所选告警</translation>
    </message>
    <message>
        <source>No sound for %1 s, unless something new is raised (Shift+A)</source>
        <translation>%1 s 内无声，除非有新告警 (Shift+A)</translation>
    </message>
    <message>
        <source>Silent for %1 s</source>
        <translation>静音剩 %1 s</translation>
    </message>
    <message>
        <source>Silence %1 s</source>
        <translation>静音 %1 s</translation>
    </message>
    <message>
        <source>%1 open · %2 in 10 min</source>
        <translation>%1 条未结 · 10 分钟内 %2 条</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>echotrail::AreaModel</name>
    <message>
        <source>Guard</source>
        <translation>警戒</translation>
    </message>
    <message>
        <source>Veto</source>
        <translation>屏蔽</translation>
    </message>
    <message>
        <source>draw %1</source>
        <translation>绘制 %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>corner of %1</source>
        <translation>%1 的角点</translation>
    </message>
    <message>
        <source>frame of %1</source>
        <translation>%1 的固定方式</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>with the vehicle</source>
        <translation>随航行器</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>固定于海底</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>固定</translation>
    </message>
</context>
<context>
    <name>echotrail::BeamPanel</name>
    <message>
        <source>Beam</source>
        <translation>波束</translation>
    </message>
    <message>
        <source>under the cursor</source>
        <translation>光标处</translation>
    </message>
    <message>
        <source>on the target</source>
        <translation>目标处</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>No beam yet</source>
        <translation>尚无波束</translation>
    </message>
    <message>
        <source>%1, %2 old   peak %3 at %4</source>
        <translation>%1，%2 前   峰值 %3，位于 %4</translation>
    </message>
    <message>
        <source>threshold not told</source>
        <translation>未告知门限</translation>
    </message>
    <message>
        <source>nothing is detected there</source>
        <translation>该处不做检测</translation>
    </message>
    <message>
        <source>threshold there %1</source>
        <translation>该处门限 %1</translation>
    </message>
    <message>
        <source>saturated cells %1</source>
        <translation>饱和单元 %1</translation>
    </message>
    <message>
        <source>bright: this beam   grey: live   dashes: threshold</source>
        <translation>亮线：此波束   灰线：实时   虚线：门限</translation>
    </message>
</context>
<context>
    <name>echotrail::ChartPanel</name>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the selected mark; Ctrl+Z brings it back</source>
        <translation>删除所选标记；Ctrl+Z 可恢复</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Guard zone…</source>
        <translation>警戒区…</translation>
    </message>
    <message>
        <source>Draw a guard zone on the fan: click its corners, Enter closes it (G)</source>
        <translation>在扇形图上绘制警戒区：逐个点击角点，按 Enter 闭合 (G)</translation>
    </message>
    <message>
        <source>Veto area…</source>
        <translation>屏蔽区…</translation>
    </message>
    <message>
        <source>Draw an area in which guard zones stay silent: click its corners, Enter closes it (V)</source>
        <translation>绘制一个警戒区不报警的区域：逐个点击角点，按 Enter 闭合 (V)</translation>
    </message>
    <message>
        <source>Fix to ground</source>
        <translation>固定于海底</translation>
    </message>
    <message>
        <source>Whether the selected area moves with the vehicle or stays</source>
        <translation>所选区域随航行器移动还是保持不动</translation>
    </message>
    <message>
        <source>Delete the selected area; Ctrl+Z brings it back</source>
        <translation>删除所选区域；Ctrl+Z 可恢复</translation>
    </message>
    <message>
        <source>Fix to vehicle</source>
        <translation>固定于航行器</translation>
    </message>
    <message>
        <source>Mark the place under the cursor, else the target (M)</source>
        <translation>标记光标所在位置，否则标记目标 (M)</translation>
    </message>
</context>
<context>
    <name>echotrail::ConnectionPanel</name>
    <message>
        <source>no link</source>
        <translation>无链路</translation>
    </message>
    <message>
        <source>waiting for the head</source>
        <translation>等待声纳头</translation>
    </message>
    <message>
        <source>asking what it is</source>
        <translation>正在识别</translation>
    </message>
    <message>
        <source>centring</source>
        <translation>正在归零</translation>
    </message>
    <message>
        <source>sending settings</source>
        <translation>正在发送设置</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>扫描中</translation>
    </message>
    <message>
        <source>head silent</source>
        <translation>声纳头无响应</translation>
    </message>
    <message>
        <source>wrong device</source>
        <translation>设备不符</translation>
    </message>
    <message>
        <source>serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or udp://HOST:PORT?listen=PORT; the list has the last ones, this computer&apos;s serial ports and simulated heads</source>
        <translation>serial:///dev/ttyUSB0?baud=115200、tcp://HOST:PORT 或 udp://HOST:PORT?listen=PORT；列表含最近地址、本机串口与模拟声纳头</translation>
    </message>
    <message>
        <source>Sonar</source>
        <translation>声纳</translation>
    </message>
    <message>
        <source>Navigation</source>
        <translation>导航</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Everything is kept, from the first byte, in the folder of recordings</source>
        <translation>从首字节起全部保存到记录文件夹</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>tracker: %1; trying again</source>
        <translation>跟踪器：%1；正在重试</translation>
    </message>
    <message>
        <source>; trying again</source>
        <translation>；正在重试</translation>
    </message>
    <message>
        <source>navigation: %1; trying again</source>
        <translation>导航：%1；正在重试</translation>
    </message>
    <message>
        <source>%1 pings</source>
        <translation>%1 个 ping</translation>
    </message>
    <message>
        <source>%1 timeouts</source>
        <translation>%1 次超时</translation>
    </message>
    <message>
        <source>%1 repeats</source>
        <translation>%1 次重发</translation>
    </message>
    <message>
        <source>%1 resets of the head</source>
        <translation>声纳头复位 %1 次</translation>
    </message>
    <message>
        <source>%1 rejected</source>
        <translation>%1 条拒收</translation>
    </message>
    <message>
        <source>%1 skipped</source>
        <translation>跳过 %1 个</translation>
    </message>
</context>
<context>
    <name>echotrail::DockTitle</name>
    <message>
        <source>Float or dock “%1”</source>
        <translation>浮动或停靠“%1”</translation>
    </message>
    <message>
        <source>Close “%1”; the Window menu brings it back</source>
        <translation>关闭“%1”；可从“窗口”菜单恢复</translation>
    </message>
</context>
<context>
    <name>echotrail::FanText</name>
    <message>
        <source>Measure </source>
        <translation>测距 </translation>
    </message>
    <message>
        <source>drag, or click two places</source>
        <translation>拖动，或点击两处</translation>
    </message>
    <message>
        <source>Guard zone </source>
        <translation>警戒区 </translation>
    </message>
    <message>
        <source>Veto area </source>
        <translation>屏蔽区 </translation>
    </message>
    <message>
        <source>click its corners, Esc gives up</source>
        <translation>点击各角点，Esc 放弃</translation>
    </message>
    <message>
        <source>Enter closes it, Backspace takes a corner back</source>
        <translation>Enter 闭合，Backspace 撤回一个角点</translation>
    </message>
    <message>
        <source>Enter or let go commands, Esc gives up</source>
        <translation>Enter 或松开即下达，Esc 放弃</translation>
    </message>
    <message>
        <source>commanded, not confirmed</source>
        <translation>已下达，未确认</translation>
    </message>
    <message>
        <source>Sector </source>
        <translation>扇区 </translation>
    </message>
    <message>
        <source>Cursor </source>
        <translation>光标 </translation>
    </message>
    <message>
        <source>stands out </source>
        <translation>突出 </translation>
    </message>
    <message>
        <source>level </source>
        <translation>电平 </translation>
    </message>
    <message>
        <source>  beam age </source>
        <translation>  波束龄 </translation>
    </message>
    <message>
        <source>ECHO OFF</source>
        <translation>回波关</translation>
    </message>
    <message>
        <source>MOVING ONLY</source>
        <translation>仅运动</translation>
    </message>
    <message>
        <source>ENHANCED</source>
        <translation>增强</translation>
    </message>
    <message>
        <source>RAW</source>
        <translation>原始</translation>
    </message>
    <message>
        <source>GROUND FIXED</source>
        <translation>对地固定</translation>
    </message>
    <message>
        <source>OFF CENTRE</source>
        <translation>偏心</translation>
    </message>
    <message>
        <source>shown head up</source>
        <translation>以艏向上显示</translation>
    </message>
    <message>
        <source>Learns what lies still</source>
        <translation>正在学习静止回波</translation>
    </message>
    <message>
        <source>wait two sweeps</source>
        <translation>请等两次扫描</translation>
    </message>
    <message>
        <source>FILTERS ACTIVE</source>
        <translation>滤除生效</translation>
    </message>
    <message>
        <source>regions dropped: %1</source>
        <translation>舍弃区域：%1</translation>
    </message>
    <message>
        <source>NAVIGATION GAP</source>
        <translation>导航中断</translation>
    </message>
    <message>
        <source>tracks coast</source>
        <translation>航迹外推</translation>
    </message>
    <message>
        <source>Sweep </source>
        <translation>扫描 </translation>
    </message>
    <message>
        <source>  oldest beam </source>
        <translation>  最旧波束 </translation>
    </message>
    <message>
        <source>Next look at %1 in </source>
        <translation>下次看到 %1 还有 </translation>
    </message>
    <message>
        <source>ESS %1 / %2</source>
        <translation>ESS %1 / %2</translation>
    </message>
    <message>
        <source>no particles</source>
        <translation>无粒子</translation>
    </message>
    <message>
        <source>No echoes yet</source>
        <translation>尚无回波</translation>
    </message>
    <message>
        <source>North up needs a heading</source>
        <translation>北向上需要艏向</translation>
    </message>
    <message>
        <source>Course up needs heading and position</source>
        <translation>航向向上需要艏向和位置</translation>
    </message>
    <message>
        <source>Course up needs a vehicle that moves</source>
        <translation>航向向上需要载体在运动</translation>
    </message>
    <message>
        <source>NORTH UP</source>
        <translation>北向上</translation>
    </message>
    <message>
        <source>COURSE UP</source>
        <translation>航向向上</translation>
    </message>
    <message>
        <source>HEAD UP</source>
        <translation>艏向上</translation>
    </message>
    <message>
        <source> lost %1</source>
        <translation> 丢失 %1</translation>
    </message>
    <message>
        <source>seen %1 ago</source>
        <translation>%1前看到</translation>
    </message>
    <message>
        <source>PICTURE IS OLD</source>
        <translation>图像已旧</translation>
    </message>
    <message>
        <source>%1: the link is too slow for it</source>
        <translation>%1：链路太慢，无法传送</translation>
    </message>
</context>
<context>
    <name>echotrail::FanView</name>
    <message>
        <source>Fan</source>
        <translation>扇面</translation>
    </message>
    <message>
        <source>An area needs three corners; Esc gives it up.</source>
        <translation>区域至少需要三个角点；按 Esc 放弃。</translation>
    </message>
    <message>
        <source>There are %1 areas already; delete one first.</source>
        <translation>已有 %1 个区域；请先删除一个。</translation>
    </message>
    <message>
        <source>Drawn: %1. Drag its corners; rename or delete it under Chart.</source>
        <translation>已绘制：%1。可拖动角点；在“海图”中重命名或删除。</translation>
    </message>
</context>
<context>
    <name>echotrail::HeadControls</name>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>Head says</source>
        <translation>声纳头</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Sector</source>
        <translation>扇区</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步进</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>频道</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>Sound, m/s</source>
        <translation>声速 m/s</translation>
    </message>
    <message>
        <source>used here</source>
        <translation>本机使用</translation>
    </message>
    <message>
        <source>The head does as commanded</source>
        <translation>声纳头已按指令执行</translation>
    </message>
    <message>
        <source>Sent; the head has not confirmed it</source>
        <translation>已发送；声纳头未确认</translation>
    </message>
</context>
<context>
    <name>echotrail::LayersPanel</name>
    <message>
        <source>Echo</source>
        <translation>回波</translation>
    </message>
    <message>
        <source>Enhanced picture</source>
        <translation>增强图像</translation>
    </message>
    <message>
        <source>Regions kept</source>
        <translation>保留的区域</translation>
    </message>
    <message>
        <source>Regions dropped</source>
        <translation>舍弃的区域</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>航迹</translation>
    </message>
    <message>
        <source>Ellipses 1σ · 95 %</source>
        <translation>椭圆 1σ · 95 %</translation>
    </message>
    <message>
        <source>History, prediction</source>
        <translation>历史、预测</translation>
    </message>
    <message>
        <source>Region of interest</source>
        <translation>关注区</translation>
    </message>
    <message>
        <source>Rings and bearings</source>
        <translation>距离圈与方位</translation>
    </message>
    <message>
        <source>Target ×4</source>
        <translation>目标 ×4</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Head up</source>
        <translation>艏向上</translation>
    </message>
    <message>
        <source>North up</source>
        <translation>北向上</translation>
    </message>
    <message>
        <source>Echo levels</source>
        <translation>回波电平</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>色图</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Black at</source>
        <translation>黑电平</translation>
    </message>
    <message>
        <source>White at</source>
        <translation>白电平</translation>
    </message>
    <message>
        <source>Fade by age</source>
        <translation>按龄淡化</translation>
    </message>
    <message>
        <source>Moving only</source>
        <translation>仅显示运动</translation>
    </message>
    <message>
        <source>Guard zones</source>
        <translation>警戒区</translation>
    </message>
    <message>
        <source>Veto areas</source>
        <translation>屏蔽区</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Echo trails</source>
        <translation>回波尾迹</translation>
    </message>
    <message>
        <source>Course up</source>
        <translation>航向向上</translation>
    </message>
</context>
<context>
    <name>echotrail::MainWindow</name>
    <message>
        <source>Echotrail</source>
        <translation>Echotrail</translation>
    </message>
    <message>
        <source>Designated the echo at %1 %2; Delete takes it back.</source>
        <translation>已指定 %1 %2 处的回波；按 Delete 取消。</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>No source open</source>
        <translation>未打开数据源</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>正在打开 %1…</translation>
    </message>
    <message>
        <source>%1 was not opened: %2. Choose another file with Ctrl+O, or start the demonstration with Ctrl+D.</source>
        <translation>未能打开 %1：%2。按 Ctrl+O 选择其他文件，或按 Ctrl+D 启动演示。</translation>
    </message>
    <message>
        <source> — Echotrail</source>
        <translation> — Echotrail</translation>
    </message>
    <message>
        <source>Following %1</source>
        <translation>正在跟随 %1</translation>
    </message>
    <message>
        <source>Polling %1</source>
        <translation>正在轮询 %1</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>notes on it under FILE</source>
        <translation>备注见“文件”</translation>
    </message>
    <message>
        <source>Parameters and seed are those of the recorded run; what you set counts from then on instead.</source>
        <translation>参数与种子取自所记录的运行；您的设置自更改时起生效。</translation>
    </message>
    <message>
        <source>%1. Open the recording again with Ctrl+O.</source>
        <translation>%1。请按 Ctrl+O 重新打开记录。</translation>
    </message>
    <message>
        <source>&amp;Alerts</source>
        <translation>告警(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Acknowledge</source>
        <translation>确认(&amp;A)</translation>
    </message>
    <message>
        <source>Acknowledges the alert at the top of the list</source>
        <translation>确认列表最上面的告警</translation>
    </message>
    <message>
        <source>&amp;Silence for 30 s</source>
        <translation>静音 30 s(&amp;S)</translation>
    </message>
    <message>
        <source>No sound for 30 s, unless something new is raised</source>
        <translation>30 s 内无声，除非有新告警</translation>
    </message>
    <message>
        <source>&amp;No flashing</source>
        <translation>不闪烁(&amp;N)</translation>
    </message>
    <message>
        <source>Alerts that ask for you are shown filled instead of flashing</source>
        <translation>待确认的告警以实心显示而不闪烁</translation>
    </message>
    <message>
        <source>&amp;List</source>
        <translation>列表(&amp;L)</translation>
    </message>
    <message>
        <source>Brings the list of alerts to the front</source>
        <translation>将告警列表置前</translation>
    </message>
    <message>
        <source>Sonar</source>
        <translation>声纳</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>航迹</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Space play   ← → 5 s   Shift one sweep   Ctrl one ping   , . speed   ? shortcuts</source>
        <translation>Space 播放   ← → 5 s   Shift 一次扫描   Ctrl 一个 ping   , . 速度   ? 快捷键</translation>
    </message>
    <message>
        <source>Not connected: %1.</source>
        <translation>未连接：%1。</translation>
    </message>
    <message>
        <source>&amp;Sonar</source>
        <translation>声纳(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>连接(&amp;C)…</translation>
    </message>
    <message>
        <source>Connect to a &amp;simulated head</source>
        <translation>连接模拟声纳头(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开(&amp;D)</translation>
    </message>
    <message>
        <source>sector</source>
        <translation>扇区</translation>
    </message>
    <message>
        <source>Recording has ended: %1. Make room and connect again.</source>
        <translation>记录已停止：%1。请清理磁盘后重新连接。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open recording…</source>
        <translation>打开记录(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>Open the &amp;last one again</source>
        <translation>重新打开上一个(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Demonstration</source>
        <translation>演示(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Close recording</source>
        <translation>关闭记录(&amp;C)</translation>
    </message>
    <message>
        <source>Picture of the &amp;window</source>
        <translation>窗口截图(&amp;W)</translation>
    </message>
    <message>
        <source>Picture of the &amp;fan</source>
        <translation>扇面截图(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Day, dusk, &amp;night</source>
        <translation>白天、黄昏、夜间(&amp;N)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>图层(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Head up</source>
        <translation>艏向上(&amp;H)</translation>
    </message>
    <message>
        <source>North &amp;up</source>
        <translation>北向上(&amp;U)</translation>
    </message>
    <message>
        <source>F&amp;ollow the vehicle</source>
        <translation>跟随载体(&amp;O)</translation>
    </message>
    <message>
        <source>Fit the &amp;picture</source>
        <translation>适配画面(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>Echoes</source>
        <translation>回波</translation>
    </message>
    <message>
        <source>Enhanced picture</source>
        <translation>增强图像</translation>
    </message>
    <message>
        <source>Regions kept</source>
        <translation>保留的区域</translation>
    </message>
    <message>
        <source>Regions dropped</source>
        <translation>舍弃的区域</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Ellipses</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>History, prediction</source>
        <translation>历史、预测</translation>
    </message>
    <message>
        <source>Region of interest</source>
        <translation>关注区</translation>
    </message>
    <message>
        <source>Rings and bearings</source>
        <translation>距离圈与方位</translation>
    </message>
    <message>
        <source>Target ×4</source>
        <translation>目标 ×4</translation>
    </message>
    <message>
        <source>&amp;Track</source>
        <translation>航迹(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Designate the selected one</source>
        <translation>指定所选航迹(&amp;D)</translation>
    </message>
    <message>
        <source>Makes the track that is selected in the list the target</source>
        <translation>将列表中所选航迹设为目标</translation>
    </message>
    <message>
        <source>&amp;Clear the designation</source>
        <translation>取消指定(&amp;C)</translation>
    </message>
    <message>
        <source>No target; all tracks live on</source>
        <translation>无目标；所有航迹继续</translation>
    </message>
    <message>
        <source>&amp;Name the selected one</source>
        <translation>命名所选航迹(&amp;N)</translation>
    </message>
    <message>
        <source>Your own name for it, on this console</source>
        <translation>您在本控制台上的命名</translation>
    </message>
    <message>
        <source>&amp;Mute the selected one</source>
        <translation>静默所选航迹(&amp;M)</translation>
    </message>
    <message>
        <source>No alerts about it; the same again wants them back</source>
        <translation>不再就其告警；再次执行则恢复</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>记录(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>5 s &amp;back</source>
        <translation>后退 5 s(&amp;B)</translation>
    </message>
    <message>
        <source>5 s &amp;on</source>
        <translation>前进 5 s(&amp;O)</translation>
    </message>
    <message>
        <source>One sweep back</source>
        <translation>后退一次扫描</translation>
    </message>
    <message>
        <source>One sweep on</source>
        <translation>前进一次扫描</translation>
    </message>
    <message>
        <source>One ping back</source>
        <translation>后退一个 ping</translation>
    </message>
    <message>
        <source>One ping on</source>
        <translation>前进一个 ping</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>到开头(&amp;S)</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>到结尾(&amp;E)</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>减速(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>加速(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Parameters</source>
        <translation>参数(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>查找(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Star the selected &amp;one</source>
        <translation>收藏所选参数(&amp;O)</translation>
    </message>
    <message>
        <source>Makes it a favourite, or no longer</source>
        <translation>加入或移出收藏</translation>
    </message>
    <message>
        <source>&amp;Load set…</source>
        <translation>载入参数集(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Save set…</source>
        <translation>保存参数集(&amp;S)…</translation>
    </message>
    <message>
        <source>Selected one to its &amp;default, or as compared</source>
        <translation>所选参数恢复默认值或取对比值(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;All to their defaults, or as compared</source>
        <translation>全部恢复默认值或取对比值(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>关于(&amp;A)</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Recordings (*.echotrail *.V4LOG *.v4log *.bin);;All files (*)</source>
        <translation>记录 (*.echotrail *.V4LOG *.v4log *.bin);;所有文件 (*)</translation>
    </message>
    <message>
        <source>No recording was opened before, or they are gone. Choose one with Ctrl+O.</source>
        <translation>之前未打开过记录，或文件已不存在。请按 Ctrl+O 选择。</translation>
    </message>
    <message>
        <source>The picture could not be written to %1. Free some space or choose another folder.</source>
        <translation>截图无法写入 %1。请清理磁盘或选择其他文件夹。</translation>
    </message>
    <message>
        <source>Picture written to %1.</source>
        <translation>截图已写入 %1。</translation>
    </message>
    <message>
        <source>Connect to &amp;tracker…</source>
        <translation>连接跟踪器(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Ask for control</source>
        <translation>请求控制权(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Give control</source>
        <translation>移交控制权(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keep control</source>
        <translation>保留控制权(&amp;K)</translation>
    </message>
    <message>
        <source>Connect to a tracker</source>
        <translation>连接跟踪器</translation>
    </message>
    <message>
        <source>NO LINK TO THE TRACKER</source>
        <translation>与跟踪器无链路</translation>
    </message>
    <message>
        <source>STALE: nothing came for %1</source>
        <translation>数据陈旧：%1 未收到数据</translation>
    </message>
    <message>
        <source>LINK LOST: the picture is %1 old</source>
        <translation>链路中断：画面已过 %1</translation>
    </message>
    <message>
        <source>&amp;Beam to the front</source>
        <translation>波束窗口置前(&amp;B)</translation>
    </message>
    <message>
        <source>Level over range of the beam under the cursor, with the detection threshold</source>
        <translation>光标处波束的电平随距离变化及检测门限</translation>
    </message>
    <message>
        <source>&amp;Plan to the front</source>
        <translation>平面图置前(&amp;P)</translation>
    </message>
    <message>
        <source>Paths of the vehicle and the tracks from above, north up</source>
        <translation>航行器与航迹的俯视路径，北向上</translation>
    </message>
    <message>
        <source>&amp;Export the plan…</source>
        <translation>导出平面图(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the paths as CSV, or the plan as a PNG picture</source>
        <translation>将路径写为 CSV，或将平面图存为 PNG 图片</translation>
    </message>
    <message>
        <source>Export the plan</source>
        <translation>导出平面图</translation>
    </message>
    <message>
        <source>Paths (*.csv);;Picture (*.png)</source>
        <translation>路径 (*.csv);;图片 (*.png)</translation>
    </message>
    <message>
        <source>Plan written to %1.</source>
        <translation>平面图已写入 %1。</translation>
    </message>
    <message>
        <source>The plan could not be written to %1: %2. Choose another folder.</source>
        <translation>无法将平面图写入 %1：%2。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>海图(&amp;C)</translation>
    </message>
    <message>
        <source>Range and bearing from one place to another: drag, or click both</source>
        <translation>两点间的距离与方位：拖动，或依次点击</translation>
    </message>
    <message>
        <source>&amp;Guard zone…</source>
        <translation>警戒区(&amp;G)…</translation>
    </message>
    <message>
        <source>Draw a zone that confirmed tracks are told of in</source>
        <translation>绘制一个区域，已确认航迹进入时提示</translation>
    </message>
    <message>
        <source>&amp;Veto area…</source>
        <translation>屏蔽区(&amp;V)…</translation>
    </message>
    <message>
        <source>Draw an area in which guard zones stay silent; the tracker goes on in it</source>
        <translation>绘制一个警戒区不报警的区域；跟踪照常进行</translation>
    </message>
    <message>
        <source>&amp;Copy the cursor&apos;s place</source>
        <translation>复制光标位置(&amp;C)</translation>
    </message>
    <message>
        <source>Decimal degrees where they are known, else metres north and east</source>
        <translation>已知时为十进制度，否则为北向和东向米数</translation>
    </message>
    <message>
        <source>Put the cursor on the fan first.</source>
        <translation>请先将光标移到扇形图上。</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>已复制：%1</translation>
    </message>
    <message>
        <source>Turn the fan; where an input is missing the fan says which</source>
        <translation>旋转扇形图；缺少输入时图上会说明</translation>
    </message>
    <message>
        <source>&amp;Course up</source>
        <translation>航向向上(&amp;C)</translation>
    </message>
    <message>
        <source>Ne&amp;xt orientation</source>
        <translation>下一个朝向(&amp;X)</translation>
    </message>
    <message>
        <source>Head up, north up, course up in turn</source>
        <translation>依次切换船首向上、北向上、航向向上</translation>
    </message>
    <message>
        <source>Move what is under the cursor into the middle; 0 takes it back</source>
        <translation>将光标处移到中央；按 0 复原</translation>
    </message>
    <message>
        <source>Take back the last change of a parameter, a mark or an area</source>
        <translation>撤销最近一次对参数、标记或区域的修改</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>重做已撤销的修改</translation>
    </message>
    <message>
        <source>No mark was set: nothing is open, or there are too many.</source>
        <translation>未设置标记：没有打开数据源，或标记过多。</translation>
    </message>
    <message>
        <source>Mark M%1 set; give it a text under Chart, or take it back with Ctrl+Z.</source>
        <translation>已设置标记 M%1；可在“海图”中加注文字，或按 Ctrl+Z 撤销。</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>海图</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>波束</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>平面图</translation>
    </message>
    <message>
        <source>Guard zones</source>
        <translation>警戒区</translation>
    </message>
    <message>
        <source>Veto areas</source>
        <translation>屏蔽区</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Echo trails</source>
        <translation>回波尾迹</translation>
    </message>
    <message>
        <source>Moving only</source>
        <translation>仅显示运动</translation>
    </message>
    <message>
        <source>Address: tls://HOST:PORT, or tcp://127.0.0.1:PORT on this machine</source>
        <translation>地址：tls://主机:端口，本机为 tcp://127.0.0.1:端口</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>Opens it at what the mouse points at, or at what has the focus</source>
        <translation>打开与鼠标所指之处或焦点所在之处有关的一页</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>导览(&amp;T)</translation>
    </message>
    <message>
        <source>The three steps of the first start, on the demonstration</source>
        <translation>首次启动时的三个步骤，在演示中进行</translation>
    </message>
    <message>
        <source>Versions and licences of Echotrail and its libraries</source>
        <translation>Echotrail 及其库的版本与许可</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>D&amp;rop the selected one</source>
        <translation>丢弃所选航迹(&amp;R)</translation>
    </message>
    <message>
        <source>Nobody is told of it any more, and none begins on its echoes; Ctrl+Z takes it back</source>
        <translation>不再显示与报告，其回波上也不再产生新航迹；Ctrl+Z 恢复</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Docks for the watch (Ctrl+1)</source>
        <translation>值班用的窗口布局 (Ctrl+1)</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>回看</translation>
    </message>
    <message>
        <source>Docks for looking through recordings (Ctrl+2)</source>
        <translation>查看记录用的窗口布局 (Ctrl+2)</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>调参</translation>
    </message>
    <message>
        <source>Docks for setting parameters (Ctrl+3)</source>
        <translation>设置参数用的窗口布局 (Ctrl+3)</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>The settings in %1 cannot be read or written: this session is not remembered.</source>
        <translation>设置文件 %1 无法读写：本次会话不会被记住。</translation>
    </message>
    <message>
        <source>The settings in %1 are damaged and cannot be set aside: delete that file.</source>
        <translation>设置文件 %1 已损坏且无法移开：请删除该文件。</translation>
    </message>
    <message>
        <source>The settings were damaged: they are kept as %1, and the console begins with its defaults.</source>
        <translation>设置文件已损坏：已另存为 %1，控制台以默认设置启动。</translation>
    </message>
    <message>
        <source>drop of %1</source>
        <translation>丢弃 %1</translation>
    </message>
    <message>
        <source>Track %1 dropped; Ctrl+Z takes it back, and so does a click on its echo.</source>
        <translation>已丢弃航迹 %1；按 Ctrl+Z 恢复，点击其回波亦可。</translation>
    </message>
    <message>
        <source>The run is recorded in %1; Ctrl+Shift+O opens it.</source>
        <translation>本次运行已记录到 %1；按 Ctrl+Shift+O 打开。</translation>
    </message>
    <message>
        <source>Click two places, or drag from one to the other; Esc puts the measure away.</source>
        <translation>依次点击两处，或从一处拖到另一处；Esc 收起测距。</translation>
    </message>
    <message>
        <source>Click the corners on the fan; Enter closes the area, Esc gives it up.</source>
        <translation>在扇面上点击角点；Enter 闭合区域，Esc 放弃。</translation>
    </message>
    <message>
        <source>&amp;Recordings aboard…</source>
        <translation>船载记录(&amp;R)…</translation>
    </message>
    <message>
        <source>Mea&amp;sure</source>
        <translation>测距(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mark</source>
        <translation>标记(&amp;M)</translation>
    </message>
    <message>
        <source>Mark the moment and the place under the cursor, else the target</source>
        <translation>标记此刻与光标所在位置，否则标记目标</translation>
    </message>
    <message>
        <source>Off-centre &amp;to the cursor</source>
        <translation>偏心至光标(&amp;T)</translation>
    </message>
    <message>
        <source>All keys on one sheet; Esc puts it away</source>
        <translation>所有按键一览；Esc 收起</translation>
    </message>
    <message>
        <source>Language of all texts, changed at once</source>
        <translation>所有文字的语言，立即切换</translation>
    </message>
    <message>
        <source>To a sonar head by a serial port, TCP or UDP; its address is typed in the panel Sonar</source>
        <translation>经串口、TCP 或 UDP 连接声纳头；地址在“声纳”面板中输入</translation>
    </message>
    <message>
        <source>Set the s&amp;ector on the fan</source>
        <translation>在扇面上设置扇区(&amp;E)</translation>
    </message>
    <message>
        <source>Move its edges with the arrow keys; Enter commands the head, Esc gives up</source>
        <translation>用方向键移动扇区边界；Enter 下达给声纳头，Esc 放弃</translation>
    </message>
    <message>
        <source>Ends the live run; its recording is closed</source>
        <translation>结束实时运行；其记录随之关闭</translation>
    </message>
    <message>
        <source>Plays an .echotrail log, a Seanet Pro .V4LOG or a raw .bin; the file is only read</source>
        <translation>回放 .echotrail 日志、Seanet Pro .V4LOG 或原始 .bin；文件只读</translation>
    </message>
    <message>
        <source>The recording that was opened most recently</source>
        <translation>最近打开的记录</translation>
    </message>
    <message>
        <source>A simulated approach with the tracker running; nothing is connected or sent</source>
        <translation>跟踪器运行中的模拟接近；不连接也不发送</translation>
    </message>
    <message>
        <source>Back to the start page</source>
        <translation>回到起始页</translation>
    </message>
    <message>
        <source>Written as PNG to your folder of pictures</source>
        <translation>以 PNG 写入您的图片文件夹</translation>
    </message>
    <message>
        <source>Ends a live run cleanly and keeps the layout</source>
        <translation>干净地结束实时运行并保存布局</translation>
    </message>
    <message>
        <source>No recording was opened before</source>
        <translation>此前未打开过记录</translation>
    </message>
    <message>
        <source>The next palette; never from night to day at once</source>
        <translation>下一种配色；绝不从夜间直接跳到白天</translation>
    </message>
    <message>
        <source>The vehicle keeps its place on the screen; else the ground does</source>
        <translation>载体在屏幕上位置不变；否则地面不变</translation>
    </message>
    <message>
        <source>The whole sector, in the middle</source>
        <translation>完整扇区，居中显示</translation>
    </message>
    <message>
        <source>The window fills the screen; the same key goes back</source>
        <translation>窗口充满屏幕；再按同一键返回</translation>
    </message>
    <message>
        <source>Shows or hides it on the fan</source>
        <translation>在扇面上显示或隐藏</translation>
    </message>
    <message>
        <source>Goes there, with the tracks as they were then</source>
        <translation>跳到该处，航迹如当时所见</translation>
    </message>
    <message>
        <source>Plays on from here; at the end from the start</source>
        <translation>从此处继续播放；在末尾则从头开始</translation>
    </message>
    <message>
        <source>Fewer seconds of the recording per second</source>
        <translation>每秒播放更少的记录时间</translation>
    </message>
    <message>
        <source>More seconds of the recording per second; no ping is left out</source>
        <translation>每秒播放更多的记录时间；不漏任何 ping</translation>
    </message>
    <message>
        <source>By any part of its name or of what it does</source>
        <translation>按名称或作用中的任意部分查找</translation>
    </message>
    <message>
        <source>All parameters of a TOML file, in one step that can be undone</source>
        <translation>TOML 文件中的全部参数，一步设定，可撤销</translation>
    </message>
    <message>
        <source>All parameters as a TOML file that echotrail reads, too</source>
        <translation>全部参数存为 TOML 文件，echotrail 亦可读取</translation>
    </message>
    <message>
        <source>Can be undone like every change of a parameter</source>
        <translation>与参数的每次更改一样可以撤销</translation>
    </message>
    <message>
        <source>Shows or hides this panel</source>
        <translation>显示或隐藏此面板</translation>
    </message>
    <message>
        <source>Every panel back to where it was on the first day</source>
        <translation>所有面板回到最初的位置</translation>
    </message>
    <message>
        <source>Follows a tracker aboard: what it sees is shown here</source>
        <translation>跟随艇上跟踪器：它所见即显示在此</translation>
    </message>
    <message>
        <source>Whoever commands the tracker is asked to give control</source>
        <translation>请求当前控制者交出控制权</translation>
    </message>
    <message>
        <source>To the console that asks, else to nobody</source>
        <translation>交给请求的控制台，无人请求则无人控制</translation>
    </message>
    <message>
        <source>The console that asks is told no</source>
        <translation>拒绝请求的控制台</translation>
    </message>
    <message>
        <source>Take contr&amp;ol</source>
        <translation>接管控制权(&amp;O)</translation>
    </message>
    <message>
        <source>From a holder that has not answered for 15 s</source>
        <translation>从 15 s 未应答的持有者处接管</translation>
    </message>
    <message>
        <source>Those of the tracker, to be fetched beside the picture</source>
        <translation>跟踪器上的记录，可在观看图像的同时取回</translation>
    </message>
</context>
<context>
    <name>echotrail::ManualView</name>
    <message>
        <source>Back to the page before</source>
        <translation>返回上一页</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>手册目录</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>在手册中查找</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>查找结果</translation>
    </message>
    <message>
        <source>Nothing. Try one word, or a part of it.</source>
        <translation>没有找到。请尝试一个词或其中一部分。</translation>
    </message>
    <message>
        <source>on or off</source>
        <translation>开或关</translation>
    </message>
    <message>
        <source>Every parameter</source>
        <translation>全部参数</translation>
    </message>
    <message>
        <source>Limits: %1. Default: %2.</source>
        <translation>范围：%1。默认：%2。</translation>
    </message>
    <message>
        <source>From the next ping.</source>
        <translation>自下一个 ping 起生效。</translation>
    </message>
    <message>
        <source>From the next sweep.</source>
        <translation>自下一次扫描起生效。</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>About Echotrail</source>
        <translation>关于 Echotrail</translation>
    </message>
    <message>
        <source>operator console and tracker for a mechanically scanned sonar.</source>
        <translation>机械扫描声纳的操作控制台与跟踪器。</translation>
    </message>
    <message>
        <source>Licence: GPL-3.0-or-later. You may use, study, change and share it; it comes without any warranty.</source>
        <translation>许可：GPL-3.0-or-later。您可以使用、研究、修改和分享；不提供任何担保。</translation>
    </message>
    <message>
        <source>The whole licence</source>
        <translation>许可全文</translation>
    </message>
    <message>
        <source>It stands on</source>
        <translation>所用的库</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>库</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>许可</translation>
    </message>
    <message>
        <source>For</source>
        <translation>用途</translation>
    </message>
</context>
<context>
    <name>echotrail::MarkModel</name>
    <message>
        <source>mark M%1</source>
        <translation>标记 M%1</translation>
    </message>
    <message>
        <source>text of M%1</source>
        <translation>M%1 的文字</translation>
    </message>
    <message>
        <source>delete M%1</source>
        <translation>删除 M%1</translation>
    </message>
    <message>
        <source>%1: N %2 E %3, set in the picture of %4</source>
        <translation>%1：北 %2 东 %3，设于 %4 的图像</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Brg</source>
        <translation>方位</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
</context>
<context>
    <name>echotrail::MessageStrip</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>echotrail::ParameterDelegate</name>
    <message numerus="yes">
        <source>%n changed</source>
        <translation>
            <numerusform>%n 项已改</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>echotrail::ParameterForm</name>
    <message>
        <source>Parameter sets (*.toml)</source>
        <translation>参数集 (*.toml)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Find  Ctrl+F</source>
        <translation>查找  Ctrl+F</translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>已改</translation>
    </message>
    <message>
        <source>Only what differs from the default, or from the preset that is compared with</source>
        <translation>仅显示与默认值或对比预设不同的参数</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>收藏</translation>
    </message>
    <message>
        <source>Only what is starred; a click on the star, or Ctrl+B, stars a parameter</source>
        <translation>仅显示已收藏的；点击星号或按 Ctrl+B 收藏参数</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>全部默认</translation>
    </message>
    <message>
        <source>Select a parameter to read what it does. Enter takes a value, Esc leaves it as it was.</source>
        <translation>选择参数查看其作用。Enter 采用数值，Esc 保持原值。</translation>
    </message>
    <message>
        <source>ping</source>
        <translation>ping</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Default %1 %2. Takes effect at the next %3.</source>
        <translation>默认 %1 %2。于下一个%3生效。</translation>
    </message>
    <message>
        <source>Refused: %1.</source>
        <translation>拒绝：%1。</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>撤销：%1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>无可撤销</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation>重做：%1 (Ctrl+Shift+Z)</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>无可重做</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Sets the selected parameter as in %1</source>
        <translation>将所选参数设为 %1 中的值</translation>
    </message>
    <message>
        <source>Sets the selected parameter back to its default</source>
        <translation>将所选参数恢复默认值</translation>
    </message>
    <message>
        <source>Take all</source>
        <translation>全部采用</translation>
    </message>
    <message>
        <source>Load a parameter set</source>
        <translation>载入参数集</translation>
    </message>
    <message>
        <source>Nothing was loaded. %1. Correct the file and load it again.</source>
        <translation>未载入。%1。请改正文件后重新载入。</translation>
    </message>
    <message>
        <source>load of %1</source>
        <translation>载入 %1</translation>
    </message>
    <message>
        <source>Parameters loaded from %1; Ctrl+Z takes them back.</source>
        <translation>已从 %1 载入参数；按 Ctrl+Z 撤回。</translation>
    </message>
    <message>
        <source>Save the parameter set</source>
        <translation>保存参数集</translation>
    </message>
    <message>
        <source>Parameters saved to %1.</source>
        <translation>参数已保存到 %1。</translation>
    </message>
    <message>
        <source>%1. Choose another place.</source>
        <translation>%1。请选择其他位置。</translation>
    </message>
    <message>
        <source>&amp;Compare with</source>
        <translation>对比(&amp;C)</translation>
    </message>
    <message>
        <source>the defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>&amp;Keep as preset…</source>
        <translation>存为预设(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Load from a file…</source>
        <translation>从文件载入(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Save to a file…</source>
        <translation>保存到文件(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep as preset</source>
        <translation>存为预设</translation>
    </message>
    <message>
        <source>Name; one of yours is replaced</source>
        <translation>名称；同名的自有预设将被替换</translation>
    </message>
    <message>
        <source>All parameters are kept as preset “%1”.</source>
        <translation>全部参数已存为预设“%1”。</translation>
    </message>
    <message>
        <source>Not kept: %1.</source>
        <translation>未保存：%1。</translation>
    </message>
    <message>
        <source>Preset “%1” was not taken. %2.</source>
        <translation>未采用预设“%1”。%2。</translation>
    </message>
    <message>
        <source>preset %1</source>
        <translation>预设 %1</translation>
    </message>
    <message>
        <source>Preset “%1” is set; Ctrl+Z takes it back.</source>
        <translation>已采用预设“%1”；按 Ctrl+Z 撤回。</translation>
    </message>
    <message>
        <source>“%1” cannot be compared with. %2.</source>
        <translation>无法与“%1”对比。%2。</translation>
    </message>
    <message>
        <source>Sets all parameters as in this preset; Ctrl+Z takes them back</source>
        <translation>将全部参数设为此预设；Ctrl+Z 撤回</translation>
    </message>
    <message>
        <source>Shows only what differs, beside what is set</source>
        <translation>仅显示差异，与当前值并列</translation>
    </message>
    <message>
        <source>All parameters under a name of your own</source>
        <translation>以自定名称保存全部参数</translation>
    </message>
    <message>
        <source>All parameters of a TOML file, in one step that can be undone</source>
        <translation>TOML 文件中的全部参数，一步设定，可撤销</translation>
    </message>
    <message>
        <source>All parameters as a TOML file that echotrail reads, too</source>
        <translation>全部参数存为 TOML 文件，echotrail 亦可读取</translation>
    </message>
</context>
<context>
    <name>echotrail::ParameterModel</name>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1 was not taken by the tracker</source>
        <translation>跟踪器未采用 %1</translation>
    </message>
    <message>
        <source>%1 to its default</source>
        <translation>%1 恢复默认</translation>
    </message>
    <message>
        <source>%1 as in %2</source>
        <translation>%1 取自 %2</translation>
    </message>
    <message>
        <source>all to their defaults</source>
        <translation>全部恢复默认</translation>
    </message>
    <message>
        <source>all as in %1</source>
        <translation>全部取自 %1</translation>
    </message>
    <message>
        <source>Default %1 %2. Takes effect at the next %3.</source>
        <translation>默认 %1 %2。于下一个%3生效。</translation>
    </message>
    <message>
        <source>ping</source>
        <translation>ping</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>favourite</source>
        <translation>已收藏</translation>
    </message>
    <message>
        <source>no favourite</source>
        <translation>未收藏</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>已发送</translation>
    </message>
    <message>
        <source>in force</source>
        <translation>已生效</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>已改</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 改为 %2</translation>
    </message>
</context>
<context>
    <name>echotrail::ParameterPanel</name>
    <message>
        <source>%1 unlike %2</source>
        <translation>%1 项与 %2 不同</translation>
    </message>
    <message>
        <source>all at their defaults</source>
        <translation>全部为默认值</translation>
    </message>
    <message numerus="yes">
        <source>%n changed</source>
        <translation>
            <numerusform>%n 项已改</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>echotrail::PipelineBridge</name>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>this program has no live links</source>
        <translation>本程序不含实时链路</translation>
    </message>
</context>
<context>
    <name>echotrail::PlanView</name>
    <message>
        <source>Plan</source>
        <translation>平面图</translation>
    </message>
    <message>
        <source>N ↑  grid %1</source>
        <translation>北 ↑  网格 %1</translation>
    </message>
    <message>
        <source>No paths yet</source>
        <translation>尚无路径</translation>
    </message>
    <message>
        <source>No navigation: the vehicle
is taken to lie still, bow north</source>
        <translation>无导航：视航行器
静止、船首朝北</translation>
    </message>
</context>
<context>
    <name>echotrail::RecordingsWindow</name>
    <message>
        <source>Recordings aboard</source>
        <translation>船载记录</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Last written (UTC)</source>
        <translation>最后写入（UTC）</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>取回</translation>
    </message>
    <message>
        <source>The selected recording, whole, into this computer&apos;s folder of recordings</source>
        <translation>将所选记录完整取回到本机的记录文件夹</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>What has come stays; Fetch goes on with it</source>
        <translation>已取回的部分保留；再按“取回”即可续传</translation>
    </message>
    <message>
        <source>No tracker is followed; Sonar → Connect to tracker…</source>
        <translation>未连接跟踪器；声纳 → 连接跟踪器…</translation>
    </message>
    <message>
        <source>No link to the tracker; it goes on by itself when the link is back.</source>
        <translation>与跟踪器的链路中断；链路恢复后自动继续。</translation>
    </message>
    <message>
        <source>The list did not come: %1</source>
        <translation>未能取得列表：%1</translation>
    </message>
    <message>
        <source>being written</source>
        <translation>正在写入</translation>
    </message>
    <message>
        <source>Not fetched: %1</source>
        <translation>未取回：%1</translation>
    </message>
    <message>
        <source>Whole: %1</source>
        <translation>已完整：%1</translation>
    </message>
    <message>
        <source>Tracks, picture and health go first; a fetch takes what the link has left, and goes on by itself after a break. A recording that is being written is fetched as far as it is now.</source>
        <translation>航迹、图像和状态优先；取回只使用链路的剩余带宽，中断后自动续传。正在写入的记录只取到当前为止。</translation>
    </message>
    <message>
        <source>None has been listed so far.</source>
        <translation>尚未列出任何记录。</translation>
    </message>
    <message>
        <source>%1: %2 %, %3 of %4 rows, %5 came</source>
        <translation>%1：%2 %，%3 / %4 行，已收 %5</translation>
    </message>
</context>
<context>
    <name>echotrail::ShortcutsOverlay</name>
    <message>
        <source>play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>5 s back or on</source>
        <translation>后退或前进 5 s</translation>
    </message>
    <message>
        <source>one sweep back or on</source>
        <translation>后退或前进一次扫描</translation>
    </message>
    <message>
        <source>one ping back or on</source>
        <translation>后退或前进一个 ping</translation>
    </message>
    <message>
        <source>start, end of the recording</source>
        <translation>记录的开头、结尾</translation>
    </message>
    <message>
        <source>slower, faster</source>
        <translation>减速、加速</translation>
    </message>
    <message>
        <source>on an echo or a track: designate it</source>
        <translation>点击回波或航迹：指定为目标</translation>
    </message>
    <message>
        <source>designate the selected track</source>
        <translation>指定所选航迹为目标</translation>
    </message>
    <message>
        <source>name the selected track</source>
        <translation>命名所选航迹</translation>
    </message>
    <message>
        <source>mute the selected track: no alerts about it</source>
        <translation>静默所选航迹：不再就其告警</translation>
    </message>
    <message>
        <source>clear the designation</source>
        <translation>取消指定</translation>
    </message>
    <message>
        <source>on a track: read its card</source>
        <translation>点击航迹：查看其卡片</translation>
    </message>
    <message>
        <source>acknowledge the alert on top</source>
        <translation>确认最上面的告警</translation>
    </message>
    <message>
        <source>silence alerts for 30 s</source>
        <translation>告警静音 30 s</translation>
    </message>
    <message>
        <source>zoom the fan; 0 fits it again</source>
        <translation>缩放扇面；0 恢复适配</translation>
    </message>
    <message>
        <source>follow the vehicle</source>
        <translation>跟随载体</translation>
    </message>
    <message>
        <source>measure between two places</source>
        <translation>两点测距</translation>
    </message>
    <message>
        <source>day, dusk, night</source>
        <translation>白天、黄昏、夜间</translation>
    </message>
    <message>
        <source>full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>picture of the window</source>
        <translation>窗口截图</translation>
    </message>
    <message>
        <source>picture of the fan only</source>
        <translation>仅扇面截图</translation>
    </message>
    <message>
        <source>open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>open the last recording again</source>
        <translation>重新打开上次的记录</translation>
    </message>
    <message>
        <source>connect to a sonar head</source>
        <translation>连接声纳头</translation>
    </message>
    <message>
        <source>set the head&apos;s sector: ← → Shift Tab Enter</source>
        <translation>设置声纳头扇区：← → Shift Tab Enter</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>find a parameter</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>star the selected parameter</source>
        <translation>收藏所选参数</translation>
    </message>
    <message>
        <source>leave an edit or this sheet</source>
        <translation>退出编辑或关闭本页</translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation>本页</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>draw a guard zone, a veto area</source>
        <translation>绘制警戒区、屏蔽区</translation>
    </message>
    <message>
        <source>head up, north up, course up in turn</source>
        <translation>依次切换船首向上、北向上、航向向上</translation>
    </message>
    <message>
        <source>off-centre: the cursor&apos;s place to the middle</source>
        <translation>偏心：将光标处移到中央</translation>
    </message>
    <message>
        <source>copy the cursor&apos;s place</source>
        <translation>复制光标位置</translation>
    </message>
    <message>
        <source>beam, plan to the front and back</source>
        <translation>波束、平面图置前与还原</translation>
    </message>
    <message>
        <source>export the plan as CSV or PNG</source>
        <translation>将平面图导出为 CSV 或 PNG</translation>
    </message>
    <message>
        <source>undo a parameter, mark or area; with Shift: redo</source>
        <translation>撤销参数、标记或区域；加 Shift：重做</translation>
    </message>
    <message>
        <source>drop the selected track; Ctrl Z takes it back</source>
        <translation>丢弃所选航迹；Ctrl Z 恢复</translation>
    </message>
    <message>
        <source>docks to operate, review, tune</source>
        <translation>操作、回看、调参的窗口布局</translation>
    </message>
    <message>
        <source>the manual, at what the mouse points at</source>
        <translation>手册中与鼠标所指之处有关的一页</translation>
    </message>
    <message>
        <source>mark the moment and the place under the cursor</source>
        <translation>标记此刻与光标所在位置</translation>
    </message>
</context>
<context>
    <name>echotrail::StartPage</name>
    <message>
        <source>What do you want to look at?</source>
        <translation>您想查看什么？</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>A simulated approach at 50 m range, with the tracker running. Nothing is connected or sent.</source>
        <translation>50 m 量程的模拟接近，跟踪器运行中。不连接也不发送。</translation>
    </message>
    <message>
        <source>works offline</source>
        <translation>可离线</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Connect to a sonar head</source>
        <translation>连接声纳头</translation>
    </message>
    <message>
        <source>A SeaKing on a serial port, or by TCP or UDP. It scans as soon as it answers; all of it is recorded.</source>
        <translation>串口、TCP 或 UDP 上的 SeaKing。应答后即扫描，全部记录。</translation>
    </message>
    <message>
        <source>serial, TCP, UDP</source>
        <translation>串口、TCP、UDP</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>An .echotrail log, a Seanet Pro .V4LOG or a raw .bin. Read only; or drop the file on this window.</source>
        <translation>.echotrail 日志、Seanet Pro .V4LOG 或原始 .bin。只读；也可将文件拖到本窗口。</translation>
    </message>
    <message>
        <source>UTC as recorded</source>
        <translation>UTC 以记录为准</translation>
    </message>
    <message>
        <source>Open the last one again</source>
        <translation>重新打开上一个</translation>
    </message>
    <message>
        <source>The recording this console showed most recently.</source>
        <translation>本控制台最近显示的记录。</translation>
    </message>
    <message>
        <source>No recent recordings</source>
        <translation>无最近记录</translation>
    </message>
</context>
<context>
    <name>echotrail::StatusBar</name>
    <message>
        <source>FILE</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>POSITION</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>TRACKER</source>
        <translation>跟踪器</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>控制权</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>SONAR</source>
        <translation>声纳</translation>
    </message>
    <message>
        <source>HDG</source>
        <translation>艏向</translation>
    </message>
    <message>
        <source>REC</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>PINGS</source>
        <translation>PING</translation>
    </message>
    <message>
        <source>TRACK</source>
        <translation>航迹</translation>
    </message>
    <message>
        <source>ALERTS</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Day, dusk or night (F5)</source>
        <translation>白天、黄昏或夜间 (F5)</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>%1 · read only</source>
        <translation>%1 · 只读</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读取中</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>播放中</translation>
    </message>
    <message>
        <source>at the end</source>
        <translation>已到结尾</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>ping %1</source>
        <translation>ping %1</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>共 %1</translation>
    </message>
    <message>
        <source>lost records: %1</source>
        <translation>丢失的记录：%1</translation>
    </message>
    <message>
        <source>bytes outside any frame: %1</source>
        <translation>帧外字节：%1</translation>
    </message>
    <message>
        <source>Everything that came could be read</source>
        <translation>收到的数据均可读</translation>
    </message>
    <message>
        <source>Every record of the file was read</source>
        <translation>文件的每条记录均已读取</translation>
    </message>
    <message>
        <source>%1 rejected</source>
        <translation>%1 条拒收</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 条丢失</translation>
    </message>
    <message>
        <source> · seen %1 ago</source>
        <translation> · %1前看到</translation>
    </message>
    <message>
        <source>confirmed, no target</source>
        <translation>条已确认，未指定</translation>
    </message>
    <message>
        <source>none confirmed</source>
        <translation>无已确认</translation>
    </message>
    <message>
        <source>1 alarm</source>
        <translation>1 条警报</translation>
    </message>
    <message>
        <source>%1 alarms</source>
        <translation>%1 条警报</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 条警告</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 条警告</translation>
    </message>
    <message>
        <source>1 caution</source>
        <translation>1 条注意</translation>
    </message>
    <message>
        <source>%1 cautions</source>
        <translation>%1 条注意</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 (A acknowledges)</source>
        <translation>%1（按 A 确认）</translation>
    </message>
    <message>
        <source>Shows the list of alerts</source>
        <translation>显示告警列表</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>down</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>up</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>quiet</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Age of the last bytes from the head</source>
        <translation>声纳头最后数据的龄</translation>
    </message>
    <message>
        <source>pings/s</source>
        <translation>ping/s</translation>
    </message>
    <message>
        <source>; trying again</source>
        <translation>；正在重试</translation>
    </message>
    <message>
        <source>there and back: %1</source>
        <translation>往返：%1</translation>
    </message>
    <message>
        <source>messages that did not come: %1</source>
        <translation>未到达的消息：%1</translation>
    </message>
    <message>
        <source>yours</source>
        <translation>本台</translation>
    </message>
    <message>
        <source>nobody&apos;s</source>
        <translation>无人</translation>
    </message>
    <message>
        <source>watching</source>
        <translation>旁观</translation>
    </message>
    <message>
        <source>asked for by %1</source>
        <translation>%1 请求控制权</translation>
    </message>
    <message>
        <source>Who commands the tracker; ask for it, give it or keep it in the menu Sonar</source>
        <translation>谁在控制跟踪器；在“声纳”菜单中请求、移交或保留</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>no navigation</source>
        <translation>无导航</translation>
    </message>
    <message>
        <source>stale %1</source>
        <translation>过旧 %1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>剩余 %1</translation>
    </message>
    <message>
        <source>disk nearly full: %1</source>
        <translation>磁盘将满：%1</translation>
    </message>
    <message>
        <source>no copy here</source>
        <translation>本机无副本</translation>
    </message>
    <message>
        <source>copy waits</source>
        <translation>副本等待中</translation>
    </message>
    <message>
        <source>copy: %1 rows missed</source>
        <translation>副本缺 %1 行</translation>
    </message>
    <message>
        <source>copy here: %1</source>
        <translation>本机副本：%1</translation>
    </message>
    <message>
        <source>no copy here: %1</source>
        <translation>本机无副本：%1</translation>
    </message>
    <message>
        <source>Age of the tracker&apos;s last message, how old an echo is when it is here, and what share of the messages is lost</source>
        <translation>跟踪器最后一条消息的龄、回波到达本机时的龄，以及消息丢失的比例</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <comment>a share</comment>
        <translation>丢失 %1</translation>
    </message>
</context>
<context>
    <name>echotrail::StripChart</name>
    <message>
        <source>Course of the track&apos;s values</source>
        <translation>航迹各值的变化</translation>
    </message>
    <message>
        <source>now</source>
        <translation>现在</translation>
    </message>
</context>
<context>
    <name>echotrail::TargetCard</name>
    <message>
        <source>Range</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Bearing</source>
        <translation>方位</translation>
    </message>
    <message>
        <source>Age of last echo</source>
        <translation>最后回波的龄</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>航向</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>存在概率</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Moment m*</source>
        <translation>矩 m*</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>Why this echo</source>
        <translation>为何是此回波</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>所见</translation>
    </message>
    <message>
        <source>log likelihood</source>
        <translation>对数似然</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Near it</source>
        <translation>附近</translation>
    </message>
    <message>
        <source>NIS</source>
        <translation>NIS</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>产生</translation>
    </message>
    <message>
        <source>Regions of the last sweep in its gate: likeness to the reference, and distance</source>
        <translation>上次扫描中其门限内的区域：与参考的相似度及距离</translation>
    </message>
    <message>
        <source>Normalised innovation squared: a track that knows how sure it is has 95 % of its looks below %1</source>
        <translation>归一化新息平方：一致的航迹有 95 % 的观测低于 %1</translation>
    </message>
    <message>
        <source>No track selected</source>
        <translation>未选择航迹</translation>
    </message>
    <message>
        <source>click a row to read its card</source>
        <translation>点击一行查看其卡片</translation>
    </message>
    <message>
        <source>one look</source>
        <translation>仅一次观测</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>偏差 %1</translation>
    </message>
    <message>
        <source>%1 · %2 of %3 echoes within %4</source>
        <translation>%1 · %3 次回波中 %2 次在 %4 内</translation>
    </message>
    <message>
        <source>%1 effective of %2</source>
        <translation>有效 %1 / %2</translation>
    </message>
    <message>
        <source>target · %1</source>
        <translation>目标 · %1</translation>
    </message>
    <message>
        <source>Last looks</source>
        <translation>最近观测</translation>
    </message>
</context>
<context>
    <name>echotrail::TimelineView</name>
    <message>
        <source>Time line</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Click or drag to go to a moment of the recording</source>
        <translation>点击或拖动以跳到记录的某一时刻</translation>
    </message>
    <message>
        <source>Tracked</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>not worked out yet: pause and it will be</source>
        <translation>尚未计算：暂停后即计算</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>no recording open</source>
        <translation>未打开记录</translation>
    </message>
    <message>
        <source>ping %1</source>
        <translation>ping %1</translation>
    </message>
    <message>
        <source>fetched</source>
        <translation>已取回</translation>
    </message>
    <message>
        <source>Nothing came here then.</source>
        <translation>当时这里未收到任何数据。</translation>
    </message>
    <message>
        <source>Not seen here then; fetched into the copy of the recording.</source>
        <translation>当时这里未看到；已取回到记录副本中。</translation>
    </message>
</context>
<context>
    <name>echotrail::TourPanel</name>
    <message>
        <source>Point at your target</source>
        <translation>指定您的目标</translation>
    </message>
    <message>
        <source>A simulated approach is playing. Wait until an echo has a blue circle, and &lt;b&gt;click&lt;/b&gt; it: brackets show that it is the target now. &lt;b&gt;Tracks&lt;/b&gt;, on the right, says where it is and why its last echo was taken. &lt;b&gt;Delete&lt;/b&gt; takes the designation back.</source>
        <translation>正在播放模拟的接近过程。等到某个回波出现蓝色圆圈，&lt;b&gt;点击&lt;/b&gt;它：括号表示它已成为目标。右侧的&lt;b&gt;航迹&lt;/b&gt;说明它在何处、为何取其最近的回波。&lt;b&gt;Delete&lt;/b&gt; 取消指定。</translation>
    </message>
    <message>
        <source>Mark and measure</source>
        <translation>标记与测距</translation>
    </message>
    <message>
        <source>Put the cursor on the fan and press &lt;b&gt;K&lt;/b&gt;: a mark stays at that place of the ground. &lt;b&gt;M&lt;/b&gt; measures between two places: click one, then the other; &lt;b&gt;Esc&lt;/b&gt; puts the measure away.</source>
        <translation>将光标放在扇面上并按 &lt;b&gt;K&lt;/b&gt;：标记留在该处海底。&lt;b&gt;M&lt;/b&gt; 测量两处之间：先点一处，再点另一处；&lt;b&gt;Esc&lt;/b&gt; 收起。</translation>
    </message>
    <message>
        <source>Change a parameter</source>
        <translation>更改参数</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl+F&lt;/b&gt;, type &lt;b&gt;seed excess&lt;/b&gt;, press the down key, type a number and &lt;b&gt;Enter&lt;/b&gt;. The picture follows at once; &lt;b&gt;Ctrl+Z&lt;/b&gt; takes it back, as it does a mark. &lt;b&gt;F1&lt;/b&gt; explains what the mouse points at, &lt;b&gt;?&lt;/b&gt; shows all keys.</source>
        <translation>&lt;b&gt;Ctrl+F&lt;/b&gt;，输入 &lt;b&gt;seed excess&lt;/b&gt;，按向下键，输入数值并按 &lt;b&gt;Enter&lt;/b&gt;。画面随即变化；&lt;b&gt;Ctrl+Z&lt;/b&gt; 撤回，标记亦然。&lt;b&gt;F1&lt;/b&gt; 解释鼠标所指之处，&lt;b&gt;?&lt;/b&gt; 显示全部按键。</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
    <message>
        <source>✓ Done.</source>
        <translation>✓ 已完成。</translation>
    </message>
    <message>
        <source>Try it now, or go on.</source>
        <translation>现在试一试，或继续下一步。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>退出导览</translation>
    </message>
    <message>
        <source>Help → Tour brings it back</source>
        <translation>可从“帮助 → 导览”再次打开</translation>
    </message>
</context>
<context>
    <name>echotrail::TrackModel</name>
    <message>
        <source>confirmed</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>coasting</source>
        <translation>外推</translation>
    </message>
    <message>
        <source>tentative</source>
        <translation>暂定</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>muted</source>
        <translation>已静默</translation>
    </message>
    <message>
        <source>, target</source>
        <translation>，目标</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Range m</source>
        <translation>距离 m</translation>
    </message>
    <message>
        <source>Brg °R</source>
        <translation>舷角 °R</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Crs °T</source>
        <translation>航向 °T</translation>
    </message>
    <message>
        <source>Crs °R</source>
        <translation>航向 °R</translation>
    </message>
    <message>
        <source>Age s</source>
        <translation>龄 s</translation>
    </message>
    <message>
        <source>Qual.</source>
        <translation>质量</translation>
    </message>
</context>
<context>
    <name>echotrail::TracksPanel</name>
    <message>
        <source>Tracks</source>
        <translation>航迹</translation>
    </message>
    <message>
        <source>Designate</source>
        <translation>指定</translation>
    </message>
    <message>
        <source>Make the selected track the target (Ctrl+Enter); a click on the fan does the same</source>
        <translation>将所选航迹设为目标 (Ctrl+Enter)；点击扇面亦可</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>No target (Delete); all tracks live on</source>
        <translation>无目标 (Delete)；所有航迹继续</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>静默</translation>
    </message>
    <message>
        <source>No alerts about the selected track (Ctrl+M)</source>
        <translation>不再就所选航迹告警 (Ctrl+M)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the selected track</source>
        <translation>所选航迹的名称</translation>
    </message>
    <message>
        <source>Your name for the selected track (Ctrl+R), taken by Enter; this console&apos;s only</source>
        <translation>您对所选航迹的命名 (Ctrl+R)，按 Enter 生效；仅限本控制台</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Take the selected track off fan and list (Shift+Delete); Ctrl+Z brings it back</source>
        <translation>从扇面与列表中移除所选航迹 (Shift+Delete)；Ctrl+Z 恢复</translation>
    </message>
</context>
<context>
    <name>echotrail::TransportPanel</name>
    <message>
        <source>max</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到开头</translation>
    </message>
    <message>
        <source>One ping back</source>
        <translation>后退一个 ping</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>One ping on</source>
        <translation>前进一个 ping</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>到结尾</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Seconds of the recording per second (, slower  . faster)</source>
        <translation>每秒播放的记录秒数（, 减速  . 加速）</translation>
    </message>
    <message>
        <source>Loop from here</source>
        <translation>从此处循环</translation>
    </message>
    <message>
        <source>Sets A, then B, then ends the loop</source>
        <translation>先设 A，再设 B，再结束循环</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stops where the run has got to</source>
        <translation>停在当前进度</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>跳到</translation>
    </message>
    <message>
        <source>UTC or 0:00:12.5</source>
        <translation>UTC 或 0:00:12.5</translation>
    </message>
    <message>
        <source>Go to a moment</source>
        <translation>跳到某一时刻</translation>
    </message>
    <message>
        <source>re-running: ping %1 of %2</source>
        <translation>重新运行：第 %1 / %2 个 ping</translation>
    </message>
    <message>
        <source>working out the time line</source>
        <translation>正在计算时间轴</translation>
    </message>
    <message>
        <source>reading: %1 pings</source>
        <translation>读取中：%1 个 ping</translation>
    </message>
    <message>
        <source>at the end; Space plays it again</source>
        <translation>已到结尾；Space 重新播放</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>“%1” is not in this recording. Type seconds from its start, as 0:00:12.5, or a UTC time from %2 to %3.</source>
        <translation>“%1”不在本记录内。请输入距开头的秒数，如 0:00:12.5，或 %2 至 %3 的 UTC 时间。</translation>
    </message>
    <message>
        <source>Loop until here</source>
        <translation>循环到此处</translation>
    </message>
    <message>
        <source>End loop</source>
        <translation>结束循环</translation>
    </message>
    <message>
        <source>live; it can be replayed afterwards</source>
        <translation>实时；结束后可回放</translation>
    </message>
</context>
</TS>
