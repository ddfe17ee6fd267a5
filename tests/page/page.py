"""The page of a run as a test uses it: its controls, and what is seen on it."""
from chromium import Chromium

# Of a colour of the style sheet against the page behind it, by WCAG 2.
CONTRAST = """(name) => {
    const probe = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const linear = (v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    const light = (of) => {
        probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(of);
        probe.fillRect(0, 0, 1, 1);
        const [r, g, b] = [...probe.getImageData(0, 0, 1, 1).data].map((v) => linear(v / 255));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05;
    };
    return Math.max(light(name), light('--back')) / Math.min(light(name), light('--back'));
}"""


def near(found, wanted, tolerance, what):
    assert abs(found - wanted) <= tolerance, f"{what}: {found}, not {wanted} within {tolerance}"


class Page(Chromium):
    def time(self):
        return self.run("clock.time()")

    def picture_hash(self):
        self.settle()
        return hash(self.run("player.canvas.toDataURL()"))

    def white_share(self):
        """Of the points within the first panel."""
        self.settle()
        return self.run("""(() => {
            const probe = document.createElement('canvas'), { x, y, width, height } = player.panels()[0];
            [probe.width, probe.height] = [width, height];
            const context = probe.getContext('2d', { willReadFrequently: true });
            context.drawImage(player.canvas, -x, -y);
            const points = new Uint32Array(context.getImageData(0, 0, probe.width, probe.height).data.buffer);
            return points.filter((p) => p === 0xffffffff).length / points.length;
        })()""")

    def pick(self, list_id, text):
        """Chooses from a list what begins with a text, as a reader does."""
        self.run(f"""(() => {{ const list = element('{list_id}');
            list.selectedIndex = [...list.options].findIndex((o) => o.text.startsWith({text!r}));
            list.dispatchEvent(new Event('change')); }})()""")
        self.settle()

    def push(self, button):
        self.run(f"element('{button}').scrollIntoView({{ block: 'nearest' }})")
        self.settle()
        box = self.run(f"(() => {{ const b = element('{button}').getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()")
        self.click(*box)

    def point_at(self, x, y):
        """Clicks on the canvas, in its own pixels of the page."""
        self.run("player.canvas.scrollIntoView({ block: 'nearest' })")
        self.settle()
        left, top = self.run("(() => { const b = player.canvas.getBoundingClientRect(); return [b.x, b.y]; })()")
        self.click(left + x, top + y)
        self.settle()

    def contrast(self, name):
        return self.run(f"({CONTRAST})('{name}')")
