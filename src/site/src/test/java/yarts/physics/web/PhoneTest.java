package yarts.physics.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.By;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;

/** Documents on a phone's screen. */
@Tag("long")
class PhoneTest {
    private static final Path SITE = Path.of(System.getProperty("site")).normalize();

    private ChromeDriver chromium;

    @BeforeEach
    void open() {
        chromium = Programs.chromium(390, 844);
    }

    @AfterEach
    void close() {
        if (chromium != null) chromium.quit();
    }

    @ParameterizedTest
    @ValueSource(strings = {"index.html", "docs/guide.html", "docs/cookbook.html", "docs/maintainers/quality.html"})
    void aPageStartsWithItsTitleAndNothingIsCutOff(String page) {
        chromium.get(SITE.resolve(page).toUri().toString());
        assertTrue(chromium.findElement(By.tagName("h1")).getRect().y < 100);
        assertEquals(390L, chromium.executeScript("return document.documentElement.scrollWidth"));
        assertEquals(
                0L,
                chromium.executeScript("return [...document.querySelectorAll('pre.wrapped')]"
                        + ".filter(pre => pre.scrollWidth > pre.clientWidth).length"));
        WebElement menu = chromium.findElement(By.id("menu"));
        assertFalse(menu.isDisplayed());
        chromium.findElement(By.cssSelector("[popovertarget]")).click();
        assertTrue(menu.isDisplayed());
        menu.findElement(By.linkText("Lockstep")).click();
        assertTrue(chromium.getCurrentUrl().endsWith("/docs/lockstep.html"), chromium.getCurrentUrl());
    }
}
