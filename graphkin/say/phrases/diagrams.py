"""Motion diagrams."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "panel position": ("Position", "位置线图"),
    "panel velocity": ("Velocity", "速度线图"),
    "panel acceleration": ("Acceleration", "加速度线图"),
    "panel ratio": ("Ratio", "比值"),
    "event": ("{mark} at {place}: {why}.", "{mark} {place}：{why}。"),
    "event dead": ("dead point", "死点"),
    "event limit": ("limit", "极限位置"),
    "event change": ("change point", "变点"),
    "across angle": ("direction of {name} [°]", "{name} 的方位角 /(°)"),
    "across between": ("angle {name} [°]", "夹角 {name} /(°)"),
    "across spin": ("rotation of {name} [°]", "{name} 的转角 /(°)"),
    "across slide": ("displacement of {name} [mm]", "{name} 的位移 /mm"),
    "driver": ("driver ", "原动件 "),
    "drivers": ("drivers ", "原动件 "),
}
